# SPDX-License-Identifier: Apache-2.0
"""The files of a run: frames by type, their times, exported meshes, and the scene."""
import json
import os
import re
import shutil
import subprocess

import numpy as np

from . import hdf, ply

KINDS = ('surface', 'sheet', 'oriented')


class RunError(Exception):
    """The folder is not a run, or a program is missing. The message says what to do."""


class Run:
    def __init__(self, folder):
        folder = os.path.abspath(folder)
        if os.path.basename(folder) == 'frames':
            folder = os.path.dirname(folder)
        self.folder, self.frames = folder, {}
        base = os.path.join(folder, 'frames')
        for name in sorted(os.listdir(base)) if os.path.isdir(base) else []:
            match = re.fullmatch(r'(.+?)(?:_(surface|sheet|oriented))?_(\d{6,})\.hdf', name)
            if match:
                self.frames.setdefault(match[2] or 'particles', []).append(os.path.join(base, name))
        if not self.frames:
            raise RunError(f'{folder}: is not a run folder: no frames/*.hdf')

    def times(self):
        """Returns the times of the frames, s, from the index or else from the files."""
        files = self.frames[self.first()]
        index = [n for n in os.listdir(os.path.join(self.folder, 'frames')) if n.endswith('.hdf.series')]
        known = {}
        for name in index:
            with open(os.path.join(self.folder, 'frames', name), encoding='utf-8') as file:
                known.update({entry['name']: entry['time'] for entry in json.load(file)['files']})
        return [known.get(os.path.basename(f), None) or timeOf(f) for f in files]

    def first(self):
        return next(kind for kind in (*KINDS, 'particles') if kind in self.frames)

    def scene(self):
        """Returns the scene as a dict; {} if this Python cannot read TOML (before Blender 4.1)."""
        try:
            import tomllib
        except ImportError:
            return {}
        return tomllib.loads(hdf.Frame(self.frames[self.first()][0]).read('run/scene_toml'))

    def meshes(self, kind, program=''):
        """Returns the exported mesh of each frame. Exports them if they are missing or older."""
        files = [self.meshOf(frame) for frame in self.frames[kind]]
        if all(isNewer(mesh, frame) for mesh, frame in zip(files, self.frames[kind])):
            return files
        found = shutil.which(program or os.environ.get('THAW_PROGRAM') or 'thaw')
        if not found:
            raise RunError(
                f'{self.folder}: some frames have no mesh; run `thaw export RUN --as ply --what {kind}`, '
                'or set the path of thaw in the preferences of the add-on'
            )
        command = [found, 'export', self.folder, '--as', 'ply', '--what', kind]
        if kind == 'surface':
            command.append('--uv')
        done = subprocess.run(command, capture_output=True, text=True, errors='replace')
        if done.returncode != 0:
            raise RunError(f'{" ".join(command)}: {(done.stderr or done.stdout).strip()}')
        return files

    def obstacleMeshes(self, program=''):
        """Returns vertices and triangles of the obstacles at the first frame, by name. {} without thaw."""
        frame = self.frames[self.first()][0]
        path = os.path.join(self.folder, 'export', 'obstacles.ply')
        if not isNewer(path, frame):
            found = shutil.which(program or os.environ.get('THAW_PROGRAM') or 'thaw')
            if not found:
                return {}
            command = [found, 'export', frame, '--as', 'ply', '--what', 'obstacles', '--out', path]
            if subprocess.run(command, capture_output=True).returncode != 0:
                return {}
        return ply.objects(path)

    def meshOf(self, frame):
        name = os.path.splitext(os.path.basename(frame))[0] + '.ply'
        return os.path.join(self.folder, 'export', name)


def isNewer(mesh, frame):
    try:
        return os.stat(mesh).st_mtime_ns >= os.stat(frame).st_mtime_ns
    except OSError:
        return False


def timeOf(path):
    return float(hdf.Frame(path).read('VTKHDF/FieldData/Time')[0])


def fieldsOf(path):
    """Returns positions and fields of a frame: float arrays by name."""
    frame = hdf.Frame(path)
    names = frame.names('VTKHDF/PointData')
    return frame.read('VTKHDF/Points'), {name: frame.read('VTKHDF/PointData/' + name) for name in names}


def meshFields(path, particles):
    """Returns vertices, triangles and attributes of a mesh file.

    particles: the frame of particles at the same time, or None. It replaces a velocity, temperature or
    liquid fraction that the mesh lacks, by that of the nearest particles.
    """
    vertices, triangles, others = ply.read(path)
    fields = {
        'normal': ply.vectors(others, ('nx', 'ny', 'nz')),
        'colour': ply.vectors(others, ('red', 'green', 'blue')),
        'velocity': ply.vectors(others, ('velocity_x', 'velocity_y', 'velocity_z')),
    }
    fields['uv'] = ply.vectors(others, ('s', 't'))
    for name in ('temperature', 'liquid'):
        fields[name] = others.get(name)
    missing = [name for name in ('velocity', 'temperature', 'liquid') if fields[name] is None]
    if particles and missing and len(vertices):
        points, values = fieldsOf(particles)
        missing = [name for name in missing if name in values]
        if missing and len(points):
            rows = nearest(points, vertices)
            for name in missing:
                fields[name] = values[name][rows]
    return vertices, triangles, {name: value for name, value in fields.items() if value is not None}


def nearest(points, queries):
    from mathutils.kdtree import KDTree

    tree = KDTree(len(points))
    for k, point in enumerate(points):
        tree.insert(point, k)
    tree.balance()
    return np.fromiter((tree.find(q)[1] for q in queries), np.int64, len(queries))
