# SPDX-License-Identifier: Apache-2.0
"""Checks a file of `thaw export --as vdb` with OpenVDB's Python module: read_vdb.py FILE VOLUME(m^3)"""

import sys

import pyopenvdb

volumes = ("density", "liquid", "surface", "temperature", "velocity")
grids = {name: pyopenvdb.read(sys.argv[1], name) for name in volumes}
try:  # the module has no type for points, and names the type that it finds
    pyopenvdb.read(sys.argv[1], "points")
    assert False, "points of an unknown type"
except TypeError as error:
    assert "ptdataidx32" in str(error), error
with open(sys.argv[1], "rb") as file:
    data = file.read()
points = data[data.rfind(b"ptdataidx32") :]  # the last grid, with the names and types of its attributes
for part in (b"vec3s", b"int64", b"temperature", b"liquid", b"id"):
    assert part in points, part
surface = grids["surface"]
assert surface.gridClass == "level set"
voxel = surface.transform.voxelSize()[0]
inside = sum(1 for v in surface.iterAllValues() if v.count == 1 and v.value < 0)
inside += sum(v.count for v in surface.iterAllValues() if v.count > 1 and v.value < 0)
volume, expected = inside * voxel**3, float(sys.argv[2])
assert abs(volume - expected) < 0.1 * expected, (volume, expected)
low, high = grids["density"].evalMinMax()
assert 0 <= low and 0.8 < high <= 1, (low, high)
low, high = grids["liquid"].evalMinMax()
assert -1e-4 < low and high < 1.0001, (low, high)
low, high = grids["temperature"].evalMinMax()
assert 250 < low and high < 700, (low, high)
