#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""chart.py CSV PICTURE: time of a step over the fraction of sleeping particles."""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

with open(sys.argv[1]) as file:
    rows = list(csv.DictReader(file))
share = [100 * float(r["asleep_share"]) for r in rows]
figure, axes = pyplot.subplots(figsize=(6, 4), layout="constrained")
axes.plot(share, [1000 * float(r["us_per_particle_awake"]) for r in rows], "o-", label="without sleep")
axes.plot(share, [1000 * float(r["us_per_particle_sleep"]) for r in rows], "s-", label="with sleep")
axes.set_xlabel("particles asleep in the end (%)")
axes.set_ylabel("ns per particle and step")
axes.set_ylim(bottom=0)
axes.legend()
figure.savefig(sys.argv[2], dpi=110)
