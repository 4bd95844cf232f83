# SPDX-License-Identifier: Apache-2.0
"""Checks the triangles of surfaces: angles.py FILE.ply...

Over all files 99.9 % of the smallest angles exceed 15 degrees, and none is below 5. Meshes are closed and
oriented: each edge has one triangle in each direction.
"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "blender", "thaw_io"))
import ply  # noqa: E402

angles = []
for path in sys.argv[1:]:
    x, triangles, _ = ply.read(path)
    x = x.astype(float)
    edges = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]).astype(np.int64)
    there, back = edges[:, 0] * len(x) + edges[:, 1], edges[:, 1] * len(x) + edges[:, 0]
    assert len(np.unique(there)) == len(there) and np.array_equal(np.sort(there), np.sort(back)), path
    corner = x[triangles]
    smallest = np.full(len(triangles), np.pi)
    for k in range(3):
        u, v = (
            corner[:, (k + 1) % 3] - corner[:, k],
            corner[:, (k + 2) % 3] - corner[:, k],
        )
        cosine = (u * v).sum(axis=1) / np.sqrt((u * u).sum(axis=1) * (v * v).sum(axis=1))
        smallest = np.minimum(smallest, np.arccos(np.clip(cosine, -1, 1)))
    angles.append(np.degrees(smallest))
angles = np.concatenate(angles)
share = (angles < 15).mean()
print(f"{len(angles)} triangles, {100 * share:.3f} % below 15 degrees, the smallest {angles.min():.1f}")
assert len(angles) > 10000 and share <= 0.001 and angles.min() >= 5
