# SPDX-License-Identifier: Apache-2.0
"""Simulations from Python, on any number of ranks: mpirun -n 3 python3 -m pytest test_simulation.py"""

import gc
import os
import resource
import signal
import subprocess
import sys
import tempfile

import numpy as np
import pytest

thaw = pytest.importorskip('thaw')
try:
    from mpi4py import MPI

    COMM = MPI.COMM_WORLD
except ImportError:
    COMM = None
RANKS = COMM.size if COMM else 1
PROGRAM = os.environ.get('THAW_PROGRAM', 'thaw')
SCENES = os.environ.get('THAW_SCENES', os.path.join(os.path.dirname(__file__), '../../scenes'))


def drop(**keys):
    scene = {
        'spacing': '5 cm',
        'end': 1,
        'domain': {'min': [-1, -1, -1], 'max': [1, 1, 1], 'gravity': [0, 0, 0]},
        'material': {'water': {'density': 1000, 'sound_speed': 20}},
        'body': [{'name': 'drop', 'sphere': {'radius': 0.3}, 'material': 'water'}],
    }
    scene.update(keys)
    return thaw.Scene(scene)


def plate():
    return thaw.Scene(
        spacing=0.05,
        end=1,
        domain={'min': [0, 0, 0], 'max': [0.4, 0.4, 0.4], 'gravity': [0, 0, 0]},
        material={
            'wax': {
                'density': 1000,
                'young': 1e5,
                'heat_capacity': 100,
                'conductivity': 1,
                'heat_source': 1e-9,
            }
        },
        body=[
            {
                'name': 'plate',
                'box': {'size': [0.3, 0.3, 0.1]},
                'place': {'move': [0.2, 0.2, 0.2]},
                'temperature': 300,
                'material': 'wax',
            }
        ],
    )


@pytest.fixture
def folder():
    """A new folder, the same on all ranks."""
    name = tempfile.mkdtemp() if not COMM or COMM.rank == 0 else None
    return COMM.bcast(name) if COMM else name


def test_steps_and_times():
    sim = thaw.Simulation(drop())
    assert sim.time == 0 and sim.steps == 0 and sim.end == 1 and sim.ranks == RANKS
    assert sim.step()
    sim.run(steps=4)
    assert sim.steps == 5
    sim.run(until=0.02)
    assert sim.time == 0.02
    assert not sim.stopped


def test_fields_have_units_and_meanings():
    sim = thaw.Simulation(drop())
    unit, about, components = sim.fields()['relative_density']
    assert unit == '1' and 'density' in about and components == 1
    assert sim.tables == ['particles']


def test_arrays_share_the_memory_of_the_simulation():
    sim = thaw.Simulation(drop())
    sim.run(steps=3)
    with sim.local() as p:
        assert p.position.shape == (len(p), 3)
        assert np.shares_memory(p['position'], p['position'])
        assert not p.position.flags.writeable
        with pytest.raises(KeyError, match='unknown field .colour.; the particles have'):
            p['colour']
    with pytest.raises(RuntimeError, match='block'):
        p['position']


def test_no_step_while_an_array_is_in_use():
    sim = thaw.Simulation(drop())
    with sim.local() as p:
        half = p.position[::2]
    with pytest.raises(RuntimeError, match='still in use'):
        sim.step()
    del half
    assert sim.step()


def test_changes_are_in_the_ledger():
    sim = thaw.Simulation(drop())
    sim.run(steps=3)
    mass = sim.ledger['mass']
    with sim.local() as p:
        p.velocity += [2, 0, 0]
    sim.run(steps=3)
    now = sim.ledger
    assert now['momentum_x'] == pytest.approx(2 * mass, rel=1e-9)
    assert now['outside_work'] == pytest.approx(0.5 * 4 * mass, rel=1e-2)
    assert abs(now['energy_residual']) < 1e-3 * now['energy_scale']


def test_temperatures_can_be_set():
    sim = thaw.Simulation(plate())
    with sim.local() as p:
        p['temperature'] = p.temperature + 10
    sim.run(steps=3)
    now = sim.ledger
    assert now['heat_in'] == pytest.approx(100 * 10 * now['mass'], rel=1e-6)
    assert abs(now['heat_residual']) < 1e-9 * now['heat_scale']


def test_a_harmonic_trap_swings_as_it_should():
    """A ball that a force -k x of its mass pulls to the origin: x = x0 cos(omega t)."""
    omega, start = 20.0, 0.05
    scene = drop()
    scene['material'] = {'jelly': {'density': 1000, 'young': 1e6}}
    scene['body'] = [
        {'name': 'ball', 'sphere': {'radius': 0.2}, 'place': {'move': [start, 0, 0]}, 'material': 'jelly'}
    ]
    sim = thaw.Simulation(scene)

    def centre():
        x = sim.gather('position')
        return x[:, 0].mean()

    first = centre()
    sim.add_force(lambda p, t: -(omega**2) * p.mass[:, None] * p.position)
    worst = 0.0
    for n in range(1, 9):
        sim.run(until=n * 0.04)
        worst = max(worst, abs(centre() - first * np.cos(omega * sim.time)))
    assert worst < 0.002 * abs(first)


def test_heat_of_a_lamp_is_balanced():
    sim = thaw.Simulation(plate())
    sim.add_heat(lambda p, t: np.where(p.position[:, 2] > 0.22, 50.0 * p.mass, 0.0))
    sim.run(until=0.02)
    now = sim.ledger
    assert now['heat_in'] > 0
    assert abs(now['heat_residual']) < 1e-9 * now['heat_scale']
    assert sim.gather('temperature').max() > 300


def test_heat_needs_a_scene_with_heat():
    with pytest.raises(ValueError, match='no heat'):
        thaw.Simulation(drop()).add_heat(lambda p, t: 0)


def test_errors_have_the_place_of_the_command_line():
    with pytest.raises(thaw.SceneError, match='scene:1:11: error: spacing: must be > 0 m, got -1'):
        thaw.Simulation({'spacing': -1})
    with pytest.raises(thaw.SceneError, match="absent.toml"):
        thaw.Simulation('absent.toml')


def test_errors_of_functions_end_the_run_after_the_step():
    sim = thaw.Simulation(drop())

    def fail(s):
        if s.steps == 3:
            raise KeyError('mine')

    sim.on_step(fail)
    with pytest.raises(KeyError, match='mine'):
        sim.run()
    assert sim.steps in (3, 4)  # several ranks stop together, one step later
    assert sim.step()


@pytest.mark.skipif(RANKS > 1, reason='mpirun ends all ranks')
def test_an_interrupt_leaves_a_state_that_goes_on():
    sim = thaw.Simulation(drop())
    sim.on_step(lambda s: os.kill(os.getpid(), signal.SIGINT) if s.steps == 2 else None)
    with pytest.raises(KeyboardInterrupt):
        sim.run()
    assert sim.steps == 2
    sim.run(steps=1)
    assert sim.steps == 3


def test_simulations_are_independent():
    one, two = thaw.Simulation(drop()), thaw.Simulation(drop())
    for _ in range(4):
        one.step()
        two.step()
    alone = thaw.Simulation(drop())
    alone.run(steps=4)
    for sim in (one, two):
        assert np.array_equal(sim.gather('position'), alone.gather('position'))


@pytest.mark.skipif(RANKS > 1, reason='one rank shows it')
def test_constructions_leak_nothing():
    small = drop(spacing='20 cm')

    def used(count):
        for _ in range(count):
            sim = thaw.Simulation(small)
            sim.on_step(lambda s: sim.time)  # refers to itself
            sim.add_force(lambda p, t: 0)
            sim.step()
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    before = used(100)
    gc.collect()
    assert used(900) - before < 8 * 1024  # KiB


@pytest.mark.parametrize('scene', ['dam_break', 'melt', 'pour'])
def test_same_bits_as_the_command_line(scene, folder):
    file = os.path.join(SCENES, scene + '.toml')
    spacing = {'dam_break': 0.08, 'melt': 0.05, 'pour': 0.02}[scene]
    sim = thaw.Simulation(file, folder + '/python', set={'spacing': spacing})
    sim.run(steps=30)
    sim.finish()
    if COMM:
        COMM.Barrier()
    if sim.rank == 0:
        clean = {k: v for k, v in os.environ.items() if not k.startswith(('OMPI', 'PMIX', 'PRTE'))}
        run = [
            PROGRAM,
            'run',
            file,
            '--set',
            f'spacing={spacing}',
            '--steps',
            '30',
            '--out',
            folder + '/line',
        ]
        subprocess.run(run, check=True, env=clean, stdout=subprocess.DEVNULL)
        result = subprocess.run(
            [PROGRAM, 'compare', folder + '/python', folder + '/line'],
            env=clean,
            text=True,
            capture_output=True,
        )
        assert 'equal' in result.stdout, result.stdout + result.stderr


def test_continues_from_a_checkpoint_with_a_force(folder):
    def begin(**options):
        sim = thaw.Simulation(drop(), folder, **options)
        sim.add_force(lambda p, t: -100 * p.mass[:, None] * p.position)
        return sim

    sim = begin()
    sim.run(steps=10)
    sim.write_checkpoint()
    sim.run(steps=10)
    whole, ledger = sim.gather('position'), sim.ledger
    sim.close()
    sim = begin(restart=True)
    assert sim.steps == 10
    sim.run(steps=10)
    assert np.array_equal(sim.gather('position'), whole)
    assert sim.ledger == ledger


def test_progress_is_a_bar(capfd):
    sim = thaw.Simulation(drop())
    sim.run(until=0.01, progress=True)
    if sim.rank == 0:
        assert '100.0 %' in capfd.readouterr().err


def test_log_receives_lines():
    lines = []
    sim = thaw.Simulation(drop(), log=lines.append)
    sim.run(steps=1)
    assert (sim.rank != 0) == (not lines)
    assert not sys.stdout.closed


def test_extensions_have_keys_in_scenes():
    thaw.register_extension(
        'trap',
        {'omega': (10, '1/s', 0, 1e6, 'frequency of the trap')},
        force=lambda p, t, values: -values['omega'] ** 2 * p.mass[:, None] * p.position,
        step_limit=lambda values: 0.1 / values['omega'],
    )
    sim = thaw.Simulation(drop(extension={'trap': {'omega': '20 1/s'}}))
    sim.run(until=0.05)
    assert sim.last_step <= 0.1 / 20
    now = sim.ledger
    assert abs(now['outside_work']) > 0
    assert abs(now['energy_residual']) < 0.01 * now['energy_scale']
    with pytest.raises(thaw.SceneError, match='unknown key .omegas.'):
        thaw.Simulation(drop(extension={'trap': {'omegas': 1}}))
    with pytest.raises(thaw.SceneError, match='unknown extension; this program has trap'):
        thaw.Simulation(drop(extension={'tarp': {}}))


def test_extensions_have_fields():
    def update(p, t, dt, values):
        p.dose[:] += values['power'] * dt
        p['trace'][:, 1] = p.id

    thaw.register_extension(
        'lamp',
        {'power': (100, 'W/kg')},
        heat=lambda p, t, values: values['power'] * p.mass,
        fields={'dose': ('J/kg', 'heat absorbed'), 'trace': ('1', '', 2, 0.5)},
        update=update,
    )
    scene = plate()
    del scene['material']['wax']['heat_source']  # the extension alone turns heat on
    scene['extension'] = {'lamp': {'power': 5}}
    sim = thaw.Simulation(scene)
    sim.run(until=0.01)
    assert sim.fields()['dose'] == ('J/kg', 'heat absorbed', 1)
    np.testing.assert_allclose(sim.gather('dose'), 5 * 0.01, rtol=1e-12)
    trace = sim.gather('trace')
    assert (trace[:, 0] == 0.5).all() and (trace[:, 1] == sim.gather('id')).all()
    with pytest.raises(RuntimeError, match='local'):
        sim.particles
    with sim.local() as p:
        assert sim.particles is p
        assert (sim.particles['dose'] > 0).all()
    assert abs(sim.ledger['heat_residual']) < 1e-9 * sim.ledger['heat_scale']
    assert 'dose' not in thaw.Simulation(plate()).fields()
    with pytest.raises(ValueError, match='field of the model'):
        thaw.register_extension('other', fields={'velocity': 'm/s'})


def test_on_phase_and_on_end():
    sim = thaw.Simulation(drop())
    order = []
    phases = ['predict', 'redistribute', 'density', 'forces', 'integrate', 'phase_change', 'end_of_step']
    for phase in phases:
        sim.on_phase(phase, lambda p, t, phase=phase: order.append((phase, t)))
    sim.on_end(lambda s: order.append('end'))
    sim.run(steps=2)
    assert [phase for phase, _ in order] == phases * 2
    assert order[0][1] == 0 and order[6][1] == order[7][1] > 0
    sim.finish()
    assert order[-1] == 'end'
    with pytest.raises(ValueError, match='unknown phase'):
        sim.on_phase('frces', print)


def test_errors_of_phases_end_the_step():
    sim = thaw.Simulation(drop())

    def fail(p, t):
        p.velocity[:] = 0

    sim.on_phase('forces', fail)
    with pytest.raises(ValueError, match='read-only'):
        sim.run(steps=3)
