# SPDX-License-Identifier: Apache-2.0
"""Tiny runs for the tests, made by the built program in a temporary folder."""
from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get('THAW_BUILD', ROOT / 'build/release'))
# The package in the build folder has the compiled part, where there is one.
sys.path.insert(0, str((BUILD if (BUILD / 'python/thaw').is_dir() else ROOT) / 'python'))
os.environ.setdefault('THAW_PROGRAM', str(BUILD / 'thaw'))
SETTINGS = {
    'OMPI_ALLOW_RUN_AS_ROOT': '1',
    'OMPI_ALLOW_RUN_AS_ROOT_CONFIRM': '1',
    'OMPI_MCA_rmaps_base_oversubscribe': '1',
    'OMPI_MCA_btl_vader_single_copy_mechanism': 'none',
    'OMPI_MCA_mpi_yield_when_idle': '1',
    'OMPI_MCA_pml': 'ob1',
}
os.environ.update({k: v for k, v in SETTINGS.items() if k not in os.environ})

# two drops, one of them across a periodic side
DROPS = '''
spacing = "2 mm"
end = "4 ms"
[domain]
min = ["-14 mm", "-14 mm", 0]
max = ["14 mm", "14 mm", "24 mm"]
sides = { x = "periodic", y = "periodic", z = ["wall", "open"] }
[material.milk]
density = 1000
surface_tension = 0.05
[[body]]
name = "left"
sphere = { radius = "4 mm" }
material = "milk"
place = { move = ["-14 mm", 0, "8 mm"] }
[[body]]
sphere = { radius = "3 mm" }
material = "milk"
velocity = [0, 0, -0.5]
place = { move = [0, 0, "16 mm"] }
[surface]
[output]
every = "1 ms"
fields = ["velocity", "pressure", "density", "rank", "body"]
'''

# a solid that melts from below, a sheet and a film of oriented particles
BODIES = '''
spacing = "2 cm"
end = "40 ms"
[domain]
min = [-0.3, -0.3, -0.02]
max = [0.3, 0.3, 0.5]
[material.wax]
density = 900
young = "150 kPa"
law = "neo-hookean"
viscosity = 8
sound_speed = 20
conductivity = 3000
heat_capacity = 2000
latent_heat = 20000
melts = ["45 degC", "60 degC"]
[[body]]
name = "bust"
box = { size = ["8 cm", "8 cm", "8 cm"] }
material = "wax"
temperature = "44 degC"
place = { bottom = [0, 0, 0] }
[[obstacle]]
name = "plate"
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
temperature = "250 degC"
[[sheet]]
name = "cloth"
grid = { width = "10 cm", depth = "10 cm" }
spacing = "2 cm"
place = { move = [0, 0, "20 cm"] }
warp = 80
weft = 50
[[oriented]]
name = "film"
patch = { width = "10 cm", depth = "10 cm" }
place = { move = [0, 0, "40 cm"] }
[surface]
[output]
every = "10 ms"
fields = ["velocity", "temperature", "liquid", "stress"]
'''

# an emitter alone, which begins after two frames without particles
JET = '''
spacing = "6 mm"
end = "40 ms"
[domain]
min = ["-8 cm", "-8 cm", "-1 cm"]
max = ["8 cm", "8 cm", "22 cm"]
[material.syrup]
density = 1300
viscosity = 1
[[emitter]]
name = "jug"
disc = { radius = "2 cm" }
centre = [0, 0, "10 cm"]
material = "syrup"
speed = "0.8 m/s"
start = "15 ms"
[output]
every = "10 ms"
'''

SHEET = '''
spacing = "2 cm"
end = "20 ms"
[domain]
min = [-0.3, -0.3, -0.1]
max = [0.3, 0.3, 0.3]
[[sheet]]
name = "cloth"
grid = { width = "10 cm", depth = "10 cm" }
spacing = "2 cm"
warp = 80
weft = 50
[output]
every = "10 ms"
'''


def program() -> str:
    return os.environ['THAW_PROGRAM']


def command(scene: pathlib.Path, out: pathlib.Path, *options: str, ranks: int = 1) -> list:
    launch = ['mpirun', '-q', '-n', str(ranks)] if ranks > 1 else []
    return [*launch, program(), 'run', str(scene), '--out', str(out), *options]


class Maker:
    """Makes runs in a folder."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.folder = folder

    def scene(self, name: str, text: str) -> pathlib.Path:
        path = self.folder / f'{name}.toml'
        path.write_text(text)
        return path

    def run(self, out: str, text: str, *options: str, name: str = 'drops', ranks: int = 1) -> str:
        path = self.folder / out
        line = command(self.scene(name, text), path, *options, ranks=ranks)
        # A copy, since MPI in this process adds variables that keep mpirun from starting.
        done = subprocess.run(line, capture_output=True, text=True, env=dict(os.environ))
        assert done.returncode == 0, done.stdout + done.stderr
        return str(path)


@pytest.fixture(scope='session')
def maker(tmp_path_factory: pytest.TempPathFactory) -> Maker:
    return Maker(tmp_path_factory.mktemp('runs'))


@pytest.fixture(scope='session')
def drops(maker: Maker) -> str:
    return maker.run('drops', DROPS)


@pytest.fixture(scope='session')
def dropsOnThreeRanks(maker: Maker) -> str:
    options = ('--set', 'output.pieces="ranks"', '--progress', '0.001')
    return maker.run('ranks', DROPS, *options, ranks=3)


@pytest.fixture(scope='session')
def bodies(maker: Maker) -> str:
    return maker.run('bodies', BODIES, name='bodies')


@pytest.fixture(scope='session')
def jet(maker: Maker) -> str:
    return maker.run('jet', JET, name='jet')


@pytest.fixture(scope='session')
def sheet(maker: Maker) -> str:
    return maker.run('sheet', SHEET, name='sheet')


@pytest.fixture
def copyOfDrops(drops: str, tmp_path: pathlib.Path) -> pathlib.Path:
    """A copy that a test may damage."""
    shutil.copytree(drops, tmp_path / 'copy')
    return tmp_path / 'copy'
