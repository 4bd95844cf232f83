# SPDX-License-Identifier: Apache-2.0
"""Checks a file of `thaw export --as vdb` with OpenVDB's Python module: read_vdb.py FILE VOLUME(m^3)"""

import sys

import pyopenvdb

found = {grid.name for grid in pyopenvdb.readAllGridMetadata(sys.argv[1])}
volumes = {"density", "liquid", "surface", "temperature", "velocity"}
assert found == volumes | {"points"}, found  # the module reads volumes, and lists points
grids = {name: pyopenvdb.read(sys.argv[1], name) for name in volumes}
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
