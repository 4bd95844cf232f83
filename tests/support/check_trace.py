#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""check_trace.py TRACE.json RANKS STEPS EXCHANGES

Fails unless the trace has these numbers of ranks and steps, slices of a rank nest, and exchanges overlap
with work. EXCHANGES: comma-separated names of required exchanges.
"""
import json
import sys

path, ranks, steps = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
exchanges = set(sys.argv[4].split(","))
with open(path) as f:
    events = json.load(f)["traceEvents"]


def require(ok, what):
    if not ok:
        sys.exit(f"{path}: {what}")


named = {e["pid"]: e["args"]["name"] for e in events if e["ph"] == "M" and e["name"] == "process_name"}
require(named == {r: f"rank {r}" for r in range(ranks)}, f"ranks are {named}")
overlapping = 0.0
for rank in range(ranks):
    mine = [e for e in events if e["pid"] == rank and e["ph"] != "M"]
    slices = [e for e in mine if e["ph"] == "X"]
    found = {e["args"]["step"] for e in slices if e["cat"] == "step"}
    require(
        len(found) == steps and max(found) - min(found) == steps - 1, f"rank {rank} has steps {sorted(found)}"
    )
    require({"phase", "step"} <= {e["cat"] for e in slices}, f"rank {rank} has no phases")
    slices.sort(key=lambda e: (e["ts"], -e["dur"]))
    open_ends = []  # ends of the enclosing slices
    tolerance = 2e-3  # us: times are written in ns
    for e in slices:
        require(e["dur"] >= 0 and e["ts"] >= 0, f"rank {rank}: {e}")
        while open_ends and open_ends[-1] <= e["ts"] + tolerance:
            open_ends.pop()
        end = e["ts"] + e["dur"]
        require(
            not open_ends or end <= open_ends[-1] + tolerance,
            f"rank {rank}: a slice begins in another and ends after it: {e}",
        )
        open_ends.append(end)
    begins = {e["id"]: e for e in mine if e["ph"] == "b"}
    ends = {e["id"]: e for e in mine if e["ph"] == "e"}
    require(begins.keys() == ends.keys(), f"rank {rank}: exchanges that begin or end only")
    if ranks > 1:
        require(
            exchanges <= {e["name"] for e in begins.values()}, f"rank {rank} lacks exchanges of {exchanges}"
        )
        require(any(e["args"]["bytes"] > 0 for e in begins.values()), f"rank {rank} sends nothing")
    work = [e for e in slices if e["cat"] == "phase" and e["name"] not in ("exchange", "reduce", "migrate")]
    for key, b in begins.items():
        require(ends[key]["ts"] >= b["ts"], f"rank {rank}: {b} ends before it begins")
        overlapping += sum(
            max(0.0, min(ends[key]["ts"], w["ts"] + w["dur"]) - max(b["ts"], w["ts"])) for w in work
        )
require(ranks == 1 or overlapping > 0, "no exchange overlaps with work")
print(f"{path}: {len(events)} events, {overlapping:.0f} us of exchanges during work")
