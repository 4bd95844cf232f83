# SPDX-License-Identifier: Apache-2.0
"""Compares the add-on's reader of frames with h5py: readers_check.py FRAME...

Damaged copies give FormatError or KeyError, and nothing else.
"""
import importlib.util
import pathlib
import sys
import tempfile

import h5py
import numpy as np


def load(name):
    # The package itself needs Blender.
    path = pathlib.Path(__file__).resolve().parents[2] / 'blender/thaw_io' / f'{name}.py'
    spec = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


hdf = load('hdf')


def compare(path):
    """Returns the number of datasets, which are equal."""
    frame, count = hdf.Frame(path), 0

    def look(name, other):
        nonlocal count
        if isinstance(other, h5py.Dataset):
            count += 1
            mine, its = frame.read(name), other[()]
            if isinstance(mine, str):
                assert mine == its.decode(), name
            else:
                assert mine.shape == its.shape and mine.dtype == its.dtype and np.array_equal(mine, its), name

    with h5py.File(path, 'r') as file:
        file.visititems(look)
        assert frame.names('VTKHDF/PointData') == sorted(file['VTKHDF/PointData'])
    return count


def damage(path, tries=150):
    data, random = pathlib.Path(path).read_bytes(), np.random.default_rng(1)
    with tempfile.NamedTemporaryFile() as file:
        for _ in range(tries):
            copy = bytearray(data[: random.integers(100, len(data))] if random.random() < 0.3 else data)
            for at in random.integers(0, min(len(copy), 6000), 12):
                copy[at] = random.integers(0, 256)
            pathlib.Path(file.name).write_bytes(copy)
            try:
                frame = hdf.Frame(file.name)
                for name in frame.names('VTKHDF/PointData'):
                    frame.read('VTKHDF/PointData/' + name)
            except (hdf.FormatError, KeyError):
                pass


counts = [compare(path) for path in sys.argv[1:]]
assert len(counts) > 3 and min(counts) > 10, counts
damage(sys.argv[1])
