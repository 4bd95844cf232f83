# SPDX-License-Identifier: Apache-2.0
"""Compares two pictures inside of Blender: pictures_check.py -- equal|different PICTURE PICTURE"""
import sys

import bpy
import numpy as np

expected, *paths = sys.argv[sys.argv.index('--') + 1 :]
first, second = (np.array(bpy.data.images.load(path).pixels[:]) for path in paths)
largest = np.abs(first - second).max()
print(f'largest difference: {largest:.3f}')
good = largest < 0.02 if expected == 'equal' else largest > 0.2
sys.exit(0 if good else 1)
