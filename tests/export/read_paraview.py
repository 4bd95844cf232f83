# SPDX-License-Identifier: Apache-2.0
"""Reads exported meshes with ParaView: pvpython read_paraview.py FILE.vtp FILE.ply FILE.obj

All three have the same surface and obstacles, the VTP file with all fields.
"""
import sys

from paraview import servermanager, simple

vtp, ply, obj = sys.argv[1:]


def fetch(reader):
    reader.UpdatePipeline()
    return servermanager.Fetch(reader)


def arrays(data):
    points = data.GetPointData()
    return {points.GetArrayName(k): points.GetArray(k) for k in range(points.GetNumberOfArrays())}


full = fetch(simple.XMLPolyDataReader(FileName=[vtp]))
fields = arrays(full)
wanted = {"normal", "color", "object", "component", "velocity", "temperature", "liquid"}
assert wanted <= set(fields), set(fields)
count = full.GetNumberOfPoints()
assert count > 500 and full.GetNumberOfPolys() > 1000, count
# The surface is warm; obstacles have no temperature, and the one at rest no velocity.
objects = [int(fields["object"].GetValue(k)) for k in range(count)]
warm = [fields["temperature"].GetValue(k) for k in range(count)]
labels = [int(fields["component"].GetValue(k)) for k in range(count)]
assert {0, 1, 2} == set(objects), set(objects)
for k in range(count):
    isSurface = objects[k] == 0
    assert (250 < warm[k] < 700) if isSurface else warm[k] != warm[k], (
        k,
        objects[k],
        warm[k],
    )
    assert (labels[k] >= 0) == isSurface
speeds = [max(abs(c) for c in fields["velocity"].GetTuple3(k)) for k in range(count)]
assert max(v for v, o in zip(speeds, objects) if o == 0) > 1e-3
assert min(v for v, o in zip(speeds, objects) if o == 2) > 0.1, "the lid moves"
for reader in (
    simple.PLYReader(FileNames=[ply]),
    simple.WavefrontOBJReader(FileName=obj),
):
    data = fetch(reader)
    names = set(arrays(data))
    assert data.GetNumberOfPolys() == full.GetNumberOfPolys(), names
    assert max(abs(a - b) for a, b in zip(data.GetBounds(), full.GetBounds())) < 1e-5
    print(sorted(names))
print("ParaView reads all files")
