# SPDX-License-Identifier: Apache-2.0
"""Reads a temporal VTKHDF file by the rules of its specification: read_vtkhdf.py FILE VOLUME

VOLUME: m^3 inside the triangles of the first frame.
"""
import sys

import h5py
import numpy as np

file = h5py.File(sys.argv[1])['VTKHDF']
assert file.attrs['Type'] == b'UnstructuredGrid' and list(file.attrs['Version']) == [2, 0]
steps = file['Steps']
count = steps.attrs['NSteps']
assert count == 5 and np.allclose(steps['Values'], [0, 0.05, 0.1, 0.15, 0.2], atol=1e-3)
for k in range(count):
    part, points = steps['PartOffsets'][k], steps['PointOffsets'][k]
    assert steps['NumberOfParts'][k] == 1
    cells, ids = steps['CellOffsets'][k], steps['ConnectivityIdOffsets'][k]
    numbers = [file[n][part] for n in ('NumberOfPoints', 'NumberOfCells', 'NumberOfConnectivityIds')]
    x = file['Points'][points : points + numbers[0]]
    # Each part has an offset more than cells.
    offsets = file['Offsets'][cells + part : cells + part + numbers[1] + 1]
    types = file['Types'][cells : cells + numbers[1]]
    corners = file['Connectivity'][ids : ids + numbers[2]]
    assert offsets[0] == 0 and offsets[-1] == numbers[2] and corners.max() == numbers[0] - 1
    assert (np.diff(offsets) == np.where(types == 5, 3, 1)).all() and set(types) == {1, 5}
    for name in file['PointData']:
        assert steps['PointDataOffsets'][name][k] == points
    fields = {n: v[points : points + numbers[0]] for n, v in file['PointData'].items()}
    assert {'color', 'id', 'object', 'temperature'} <= set(fields)
    assert (fields['id'][corners[-10:]] >= 0).all() and (fields['id'][corners[:10]] == -1).all()
    surface = fields['object'] == 0
    triangles = corners[: 3 * (types == 5).sum()].reshape(-1, 3)
    a, b, c = np.moveaxis(x[triangles[surface[triangles].all(axis=1)]].astype(float), 1, 0)
    volume = np.einsum('ij,ij->', a, np.cross(b, c)) / 6
    assert abs(volume / float(sys.argv[2]) - 1) < 0.02, volume
    assert 300 < fields['temperature'][surface].mean() < 380
    assert np.isfinite(fields['velocity']).all()
print('all steps are read')
