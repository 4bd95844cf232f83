# SPDX-License-Identifier: Apache-2.0
"""Compares particles that Partio has read from bgeo with their frame: read_bgeo.py PARTICLES.pda FRAME.hdf"""
import sys

import h5py
import numpy as np

lines = open(sys.argv[1]).read().splitlines()
names, types = lines[1].split(), lines[3].split()
assert lines[0] == 'ATTRIBUTES' and lines[5] == 'BEGIN DATA', lines[:6]
rows = np.array([line.split() for line in lines[6:]], float)
fields, at = {}, 0
for name, kind in zip(names, types):
    # colours are three floats
    width = 3 if kind == 'V' or name == 'Cd' else 1
    fields[name], at = rows[:, at : at + width], at + width
assert at == rows.shape[1], (names, types, rows.shape)
fields = {name: values[np.argsort(fields['id'][:, 0])] for name, values in fields.items()}
frame = h5py.File(sys.argv[2])['VTKHDF']
order = np.argsort(frame['PointData/id'])
points, data = frame['Points'][:][order], {n: v[:][order] for n, v in frame['PointData'].items()}
assert len(rows) == len(points) > 100
assert np.allclose(fields['position'], points, atol=1e-6)
assert np.allclose(fields['v'], data['velocity'], rtol=1e-4, atol=1e-6)
assert np.array_equal(fields['id'][:, 0], data['id'] & 0x7FFFFFFF)
assert np.allclose(fields['temperature'][:, 0], data['temperature'], rtol=1e-5)
assert (fields['pscale'] > 0).all() and (fields['Cd'] >= 0).all() and (fields['Cd'] <= 1).all()
print(len(rows), 'particles are read')
