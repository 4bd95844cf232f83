#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/accuracy/frontier.csv, the table of `thaw check`, for document.py.

The table covers each case that represents a part of the model (NORMS), at the spacing where settings vary
(plan.py). The defaults come first, then every setting with its keys as `--set` takes them. A mark shows the
settings that no other one beats in both error and time. The error is -1 where a run blew up, or where its
ledger does not close although that of the defaults does.
"""
import os

import plan

TARGET = os.path.join(
    os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "accuracy", "frontier.csv"
)

NORMS = {
    "hydrostatic": "L2(p)",
    "martin_moyce": "RMS(Z)",
    "poiseuille": "L2(u)",
    "drop_laplace": "pressure jump",
    "cantilever": "deflection",
    "p_wave": "P speed at 20 dx",
    "stiff_in_soft": "energy residual",
    "conductivity_ratio": "Linf(T)",
    "stefan_two_phase": "front",
}


def keyed(settings):
    """Settings of the CSV file as one scene key of any material; None if there are several keys."""
    text = settings.rsplit(" spacing=", 1)[0]
    if text == "default":
        return ""
    if text.count("=") != 1:
        return None
    if text.startswith("material."):
        return "material.*." + text.split(".", 2)[2]
    return text if text.startswith(("quality=", "body.")) else "numerics." + text


def failed(rows, settings):
    """True if the run blew up or its ledger does not close; a small error is then a coincidence."""
    of = [r for r in rows if r["settings"] == settings]
    return any(
        r["norm"].startswith("blew up")
        or (r["norm"] == "energy residual" and r["target"] and float(r["error"]) > float(r["target"]))
        for r in of
    )


def points(rows):
    """(case, norm, key=value, error, time relative to the defaults, on the frontier)"""
    for case, norm in NORMS.items():
        at = plan.CASES[case][1]
        here = [
            r
            for r in rows
            if r["case"] == case
            and f"spacing={at}" in r["settings"].split()
            and keyed(r["settings"]) is not None
        ]
        default = next((r for r in here if r["norm"] == norm and r["settings"].startswith("default")), None)
        if not default or float(default["core_seconds"]) <= 0:
            continue
        every = {}
        for settings in dict.fromkeys(r["settings"] for r in here):
            row = next((r for r in here if r["settings"] == settings and r["norm"] == norm), None)
            cost = float((row or next(r for r in here if r["settings"] == settings))["core_seconds"]) / float(
                default["core_seconds"]
            )
            every[settings] = (float(row["error"]) if row and not failed(here, settings) else -1, cost)
        best, chosen = float("inf"), {default["settings"]}
        for settings, (error, cost) in sorted(every.items(), key=lambda e: (e[1][1], e[1][0])):
            if 0 <= error < best:
                best = error
                chosen.add(settings)
        for settings, (error, cost) in sorted(every.items(), key=lambda e: e[0] != default["settings"]):
            yield case, norm, keyed(settings), error, cost, settings in chosen


def source(rows):
    """The text of frontier.csv."""
    text = "case,norm,settings,error,time,best\n"
    for case, norm, settings, error, cost, best in points(rows):
        text += f"{case},{norm},{settings},{error:.3g},{cost:.2g},{best:d}\n"
    return text


def write(rows):
    with open(TARGET, "w") as out:
        out.write(source(rows))
