#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests of model.py: geometry against counting, a fit against its own data, and limits."""
import itertools
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import model


def close(a, b, tolerance=1e-9):
    assert abs(a - b) <= tolerance * max(1.0, abs(a), abs(b)), f"{a} is not {b}"


def counted(along, side, layer):
    """Ghosts and neighbours of all boxes of a cube, one by one."""
    own = [side / a for a in along]
    total = around = 0
    for box in itertools.product(*(range(a) for a in along)):
        sides = [(b > 0) + (b < a - 1) for b, a in zip(box, along)]
        total += math.prod(o + s * layer for o, s in zip(own, sides)) - math.prod(own)
        around += math.prod(1 + s for s in sides) - 1
    return total / math.prod(along), around / math.prod(along)


for ranks, along in (
    (1, (1, 1, 1)),
    (2, (2, 1, 1)),
    (4, (2, 2, 1)),
    (8, (2, 2, 2)),
    (16, (4, 2, 2)),
    (64, (4, 4, 4)),
    (512, (8, 8, 8)),
):
    assert sorted(model.factors(ranks), reverse=True) == sorted(along, reverse=True), (
        ranks,
        model.factors(ranks),
    )
    g, n = counted(along, 100.0, 2.0)
    close(model.ghosts(1e6, ranks, 2.0), g)
    close(model.neighbours(ranks), n)
assert 25 < model.neighbours(10**6) < 26

made = model.Counts(layer=2.3, bytes_per_ghost=120.0, messages=2.1, collectives=2.2, growth=0.4)
rows = []
for ranks in (1, 2, 4, 8, 16, 32, 64):
    s = model.step(made, model.Machine(), 8000.0 * ranks, ranks)
    rows.append(
        {
            "ranks": ranks,
            "particles": 8000.0 * ranks,
            "halo_fraction": s["ghosts"] / 8000,
            "neighbours": model.neighbours(ranks),
            "messages": s["messages"],
            "kib": s["bytes"] / 1024,
            "collectives": made.collectives + made.growth * math.log2(ranks),
        }
    )
found = model.fit(rows)
for name in ("layer", "bytes_per_ghost", "messages", "collectives", "growth"):
    close(getattr(found, name), getattr(made, name), 1e-6)

m = model.Machine(imbalance=1.0)
close(model.step(made, m, 1e6, 1)["seconds"], 1e6 / m.rate)  # alone there is only work
close(model.efficiency(made, m, 1e6, 1), 1.0)
weak = [model.efficiency(made, m, 1e6 * p, p) for p in (8, 64, 512, 4096, 10000)]
strong = [model.step(made, m, 1e8, p)["seconds"] for p in (1, 8, 64, 512)]
assert all(a >= b for a, b in zip(weak, weak[1:])), weak  # more ranks are never more efficient
assert all(a > b for a, b in zip(strong, strong[1:])), strong  # and faster while there is work
assert (
    model.step(made, model.Machine(bandwidth=1e7), 1e9, 1000)["seconds"]
    > model.step(made, model.Machine(), 1e9, 1000)["seconds"]
)
try:
    model.fit([rows[0]])
    raise AssertionError("a fit to one rank")
except ValueError:
    pass
print("all passed")
