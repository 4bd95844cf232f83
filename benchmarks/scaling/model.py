#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Model of the time per step on many ranks.

model.py SCALING.csv [--ranks P] [--particles N] [--latency S] [--bandwidth B/s] [--rate PARTICLES/S] ...

A cube of N fluid particles is split over P ranks, each a box of cells. The messages of a step follow from
geometry with four numbers that are fitted to the counts measured on 1 to 64 ranks (series `counts`). Their
cost follows from inputs that describe the machine. Assumptions: particles fill a compact body evenly,
partitions are balanced to the given imbalance, and messages do not contend.
"""
import argparse
import csv
import dataclasses
import math


def factors(ranks):
    """Ranks along each axis after repeated bisection of the longest; exact where ranks is a power of two."""
    along = [1.0, 1.0, 1.0]
    left = float(ranks)
    while left > 1:
        cut = min(2.0, left)
        axis = along.index(min(along))
        along[axis] *= cut
        left /= cut
    return along


def faces(along):
    """Mean number of sides of a box that touch another box, along one axis."""
    return 2 * (along - 1) / along if along > 1 else 0.0


def neighbours(ranks):
    """Mean number of neighbouring ranks; 26 in the interior."""
    product = 1.0
    for along in factors(ranks):
        product *= 1 + faces(along)
    return product - 1


def ghosts(particles, ranks, layer):
    """Mean number of ghosts of a rank, at most all others.

    layer: particles across the layer of cells around a box.
    """
    side, with_layer, box = particles ** (1 / 3), 1.0, 1.0
    for along in factors(ranks):
        own = side / along
        with_layer *= min(own + faces(along) * layer, side)
        box *= own
    return with_layer - box


@dataclasses.dataclass
class Counts:
    """Fitted counts of a step of the fluid scene on a rank."""

    layer: float = 2.2  # particles across a layer of ghosts
    bytes_per_ghost: float = 100.0  # bytes sent per ghost and step
    messages: float = 2.0  # messages per neighbour and step
    collectives: float = 2.0  # collectives per step, with those of balance checks
    growth: float = 0.0  # additional collectives per step for each doubling of ranks
    bisection: float = (
        12.0  # collectives per level of a new bisection (parallel/decomposition.cpp); not fitted
    )


@dataclasses.dataclass
class Machine:
    """Inputs that describe the machine."""

    rate: float = 3e6  # particle-steps/s of one core while other cores compute as well
    latency: float = 2e-6  # s per message
    bandwidth: float = 4e8  # bytes/s per rank: its share of a node's network
    collective: float = 3e-6  # s of a small reduction per doubling of ranks
    table: float = 5e-7  # s per rank and new partition: tables of rank size, splits of communicators
    partition: float = 100  # steps between new partitions: the fewest that the balance allows
    imbalance: float = 1.05  # largest over mean work
    ghost_work: float = 0.15  # work of a ghost over that of an owned particle
    overlap: float = 0.0  # fraction of the exchange hidden behind work


def linear(points):
    """Least-squares fit of y = a + b x; points: (x, y)."""
    n, sx, sy = len(points), sum(x for x, _ in points), sum(y for _, y in points)
    sxx, sxy = sum(x * x for x, _ in points), sum(x * y for x, y in points)
    det = n * sxx - sx * sx
    if det == 0:
        return sy / n, 0.0
    b = (n * sxy - sx * sy) / det
    return (sy - b * sx) / n, b


def fit(rows):
    """Counts from rows of the series `counts`, case fluid.

    Their columns: ranks, particles, halo_fraction, neighbours, messages, kib, collectives.
    """
    many = [r for r in rows if r["ranks"] > 1]
    if not many:
        raise ValueError("no counts on more than one rank: run scripts/bench scaling --only counts")
    c = Counts()

    def miss(layer):  # relative error, so that all numbers of ranks weigh the same
        return sum(
            (
                ghosts(r["particles"], r["ranks"], layer) / (r["halo_fraction"] * r["particles"] / r["ranks"])
                - 1
            )
            ** 2
            for r in many
        )

    low, high = 0.5, 10.0
    for _ in range(100):  # golden section
        a, b = high - (high - low) / 1.618034, low + (high - low) / 1.618034
        low, high = (low, b) if miss(a) < miss(b) else (a, high)
    c.layer = 0.5 * (low + high)
    sent = [(r["halo_fraction"] * r["particles"] / r["ranks"], 1024 * r["kib"]) for r in many]
    c.bytes_per_ghost = sum(b for _, b in sent) / sum(g for g, _ in sent)
    c.messages = sum(r["messages"] for r in many) / sum(r["neighbours"] for r in many)
    c.collectives, c.growth = linear([(math.log2(r["ranks"]), r["collectives"]) for r in many])
    return c


def step(counts, machine, particles, ranks):
    """Seconds of a step by part, and its messages."""
    own = particles / ranks
    around = ghosts(particles, ranks, counts.layer) if ranks > 1 else 0.0
    levels = math.log2(ranks) if ranks > 1 else 0.0
    parts = {
        "work": own / machine.rate * machine.imbalance,
        "ghosts": machine.ghost_work * around / machine.rate,
    }
    exchange = (
        counts.messages * neighbours(ranks) * machine.latency
        + counts.bytes_per_ghost * around / machine.bandwidth
    )
    parts["exchange"] = (1 - machine.overlap) * exchange
    # each level of the bisection halves the number of ranks
    bisection = counts.bisection * levels * (levels + 1) / 2 / machine.partition
    parts["collectives"] = machine.collective * (
        (counts.collectives + counts.growth * levels) * levels + bisection
    )
    parts["tables"] = machine.table * ranks / machine.partition if ranks > 1 else 0.0
    return {
        "seconds": sum(parts.values()),
        "parts": parts,
        "messages": counts.messages * neighbours(ranks),
        "bytes": counts.bytes_per_ghost * around,
        "ghosts": around,
    }


def efficiency(counts, machine, particles, ranks):
    """Time of a single rank with the same particles per rank, over the time of the step."""
    return particles / ranks / machine.rate / step(counts, machine, particles, ranks)["seconds"]


def read(path, series="counts", case="fluid"):
    with open(path, newline="") as f:
        rows = [r for r in csv.DictReader(f) if r["series"] == series and r["case"] == case]
    number = lambda text: float(text) if text else 0.0
    return [
        {
            k: (v if k in ("series", "case", "level", "clock", "machine", "version") else number(v))
            for k, v in r.items()
        }
        for r in rows
    ]


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("csv")
    p.add_argument("--ranks", type=float, default=10000)
    p.add_argument("--particles", type=float, default=1e10)
    for f in dataclasses.fields(Machine):
        p.add_argument("--" + f.name.replace("_", "-"), type=float, default=f.default)
    a = p.parse_args()
    counts, machine = fit(read(a.csv)), Machine(
        **{f.name: getattr(a, f.name) for f in dataclasses.fields(Machine)}
    )
    s = step(counts, machine, a.particles, a.ranks)
    print(counts)
    print(machine)
    print(
        f"{a.particles:.3g} particles on {a.ranks:.0f} ranks: {1e3 * s['seconds']:.3f} ms a step, "
        f"efficiency {efficiency(counts, machine, a.particles, a.ranks):.3f}; "
        f"a rank sends {s['messages']:.0f} messages of {s['bytes'] / 2**20:.2f} MiB in all, "
        f"and has {s['ghosts']:.0f} ghosts"
    )
    for name, seconds in s["parts"].items():
        print(f"  {name:12s} {1e3 * seconds:9.3f} ms")


if __name__ == "__main__":
    main()
