# SPDX-License-Identifier: Apache-2.0
"""Simulations from Python, on any number of ranks: mpirun -n 3 python3 -m pytest test_simulation.py"""

import copy
import gc
import operator
import os
import pickle
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import weakref

import numpy as np
import pytest

thaw = pytest.importorskip('thaw')
try:
    from mpi4py import MPI

    COMM = MPI.COMM_WORLD
except ImportError:
    COMM = None
RANKS = COMM.size if COMM else 1
LAUNCHER = ('OMPI_COMM_', 'OMPI_UNIVERSE', 'OMPI_MCA_orte', 'OMPI_MCA_ess', 'OMPI_APP', 'PMIX', 'PMI_')
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


def test_all_fields_of_frames_have_a_meaning():
    fields = drop().schema()['properties']['output']['properties']['fields']['items']['enum']
    assert len(fields) > 10
    for name in set(fields) - {'surface_velocity'}:  # surfels have it as 'velocity'
        assert thaw.meanings.meaningOf('particles', name), name


def test_arrays_share_the_memory_of_the_simulation():
    sim = thaw.Simulation(drop())
    sim.run(steps=3)
    with sim.local() as p:
        assert p.position.shape == (len(p), 3)
        assert np.shares_memory(p['position'], p['position'])
        assert not p.position.flags.writeable
        with pytest.raises(KeyError, match="table 'particles' has no field 'colour'. There are: "):
            p['colour']
    with pytest.raises(RuntimeError, match='block'):
        p['position']


def test_arrays_end_with_their_block():
    sim = thaw.Simulation(drop())
    with sim.local() as p:
        position, half, plain = p.position, p.velocity[::2], np.asarray(p.velocity)
        single = p.mass[:1]
        before = plain.copy()
        copies = p.position.copy(), p.position + 0, p.position[p.mass > 0], p.position.flatten()[::3]
    for access in (
        lambda: position[0],
        lambda: position.sum(),
        lambda: half + 1,
        lambda: np.concatenate([position, position]),
        lambda: half.__setitem__(0, 1),
        lambda: half.__iadd__(1),
        lambda: len(position),
        lambda: position.copy(),
        lambda: position == 0,
        lambda: 0 != position,
        lambda: np.zeros_like(before) == position,
        lambda: 0 in position,
        lambda: position.flat,
        lambda: position.data,
        lambda: position.T,
        lambda: position.shape,
        lambda: position.view(np.ndarray),
        lambda: position.flatten(),
        lambda: position.take([0]),
        lambda: position.__array_interface__,
        lambda: half.sort(),
        lambda: copy.copy(position),
        lambda: copy.deepcopy(position),
        lambda: pickle.dumps(position),
        lambda: list(position),
        lambda: float(single),
        lambda: bool(single),
        lambda: len(p),
        lambda: list(p),
        lambda: 'position' in p,
        lambda: p.fields(),
        lambda: p.position,
    ):
        with pytest.raises(RuntimeError, match='ended'):
            access()
    assert all(len(own) == len(before) for own in copies)  # these are the program's own
    assert all((own == own).all() for own in copies)
    assert repr(position) == '<array of a block that has ended>'
    assert np.array_equal(np.asarray(position), copies[0])  # conversions read the buffer itself
    plain[:] = 5  # changes only this array
    assert np.all(sim.gather('velocity') == 0) and sim.ledger['momentum_x'] == 0
    assert sim.step()
    assert np.array_equal(before, np.zeros_like(before)) and (plain == 5).all()


def test_rows_are_iterated_by_field():
    sim = thaw.Simulation(drop())
    with sim.local() as p:
        assert list(p) == p.fields() == list(sim.fields())
        assert 'velocity' in p and 'colour' not in p and 3 not in p
        assert all(len(p[name]) == len(p) for name in p)
        with pytest.raises(TypeError, match='expected the name of a field, such as .*, got 3'):
            p[3]


@pytest.mark.skipif(RANKS > 1, reason='one rank shows it')
def test_arrays_outlive_their_simulation():
    def kept():
        sim = thaw.Simulation(drop())
        with sim.local() as p:
            return np.asarray(p.position), p

    x, rows = kept()
    gc.collect()
    before = x.copy()
    junk = [np.full((len(x), 3), 7.0) for _ in range(50)]
    assert np.array_equal(x, before) and len(junk) == 50
    with pytest.raises(RuntimeError, match='ended'):
        len(rows)


def test_a_closed_simulation_is_named():
    sim = thaw.Simulation(drop())
    with sim.local() as p:
        x = np.asarray(p.position)
        with pytest.raises(RuntimeError, match='close: not possible in a block'):
            sim.close()
    assert 'step 0' in repr(sim)
    sim.close()
    sim.close()
    assert 'closed' in repr(sim) and x.sum() == x.copy().sum()
    with pytest.raises(RuntimeError, match='the simulation is closed'):
        sim.step()


def test_arrays_kept_by_functions_are_separate():
    sim = thaw.Simulation(drop())
    kept, rows = [], []

    def keep_in_step(s):
        with s.local() as p:
            kept.append(np.asarray(p.position))

    def keep_in_force(p, t):
        kept.append(np.asarray(p.position))
        rows.append(p)
        return 0

    sim.on_step(keep_in_step)
    sim.on_phase('predict', lambda p, t: kept.append(np.asarray(p.velocity)))
    sim.add_force(keep_in_force)
    sim.run(steps=4)
    alone = thaw.Simulation(drop())
    alone.run(steps=4)
    assert np.array_equal(sim.gather('position'), alone.gather('position'))
    assert len(kept) == 1 + 4 * 3 and all(np.isfinite(x).all() for x in kept)
    with pytest.raises(RuntimeError, match='ended'):
        rows[0].position


def test_blocks_are_not_nested():
    sim = thaw.Simulation(drop())
    with sim.local() as p:
        with pytest.raises(RuntimeError, match='a block of the particles is open'):
            with sim.local():
                pass
        for change in (sim.step, sim.run, sim.finish, lambda: sim.add_force(lambda p, t: 0)):
            with pytest.raises(RuntimeError, match='not possible in a block'):
                change()
        assert len(p) == len(p.position)
    assert sim.step()
    with sim.local('particles') as p, pytest.raises(KeyError, match="has no table '"):
        with sim.local('colours'):
            pass


def test_no_step_within_a_step():
    calls = ('step', 'run', 'finish', 'close', 'restore')
    for call in [operator.methodcaller(name) for name in calls] + [lambda s: s.add_force(lambda p, t: 0)]:
        sim = thaw.Simulation(drop())
        sim.on_step(call)
        with pytest.raises(RuntimeError, match='not possible within a step'):
            sim.run(steps=2)
        assert sim.steps == 1


@pytest.mark.skipif(RANKS > 1, reason='one rank shows it')
def test_two_threads_do_not_step_together():
    sim = thaw.Simulation(drop(spacing='3 cm'))
    begun, errors = threading.Event(), []
    sim.on_step(lambda s: begun.set())
    thread = threading.Thread(target=lambda: sim.run(steps=60))
    thread.start()
    begun.wait()
    for call in (sim.step, lambda: sim.time, lambda: sim.gather('id'), lambda: sim.ledger, sim.close):
        try:
            call()
        except RuntimeError as error:
            errors.append(str(error))
    sim.request_stop()
    thread.join()
    assert errors == ['another thread is stepping this simulation; wait until it has ended'] * 5
    assert sim.stopped and sim.steps < 60


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


@pytest.mark.skipif(RANKS > 1, reason='the same on each rank')
def test_arguments_of_other_types_are_refused():
    with pytest.raises(thaw.SceneError, match='scene:1:1: error: there is nothing to simulate'):
        thaw.Simulation({})
    for given in (3, None):
        with pytest.raises(TypeError, match=f'scene: expected a path, a dict or a Scene, got {given}'):
            thaw.Simulation(given)
    for name, wrong, expected in (
        ('comm', 4, 'a communicator of mpi4py'),
        ('log', 3, 'a function'),
        ('out', 3, 'a path'),
        ('set', [1], 'a dict'),
        ('time_limit', '1 h', 'a number'),
    ):
        with pytest.raises(TypeError, match=f'{name}: expected {expected}, got '):
            thaw.Simulation(drop(), **{name: wrong})
    sim = thaw.Simulation(drop())
    for call, message in (
        (lambda: sim.run(until='x'), "until: expected a number, got 'x'"),
        (lambda: sim.run(steps=2.5), 'steps: expected a whole number, got 2.5'),
        (lambda: sim.on_step(3), 'call: expected a function, got 3'),
        (lambda: sim.on_phase('forces', 3), 'call: expected a function, got 3'),
        (lambda: sim.add_force(3), 'force: expected a function, got 3'),
    ):
        with pytest.raises(TypeError, match=message):
            call()
    for call, name in ((lambda: sim.gather('colour'), 'colour'), (lambda: sim.fields('solid'), 'solid')):
        with pytest.raises(thaw.FieldError, match=f"has no (field|table) '{name}'. There are: "):
            call()


def raising(sim, number, error):
    """A function that raises on the last rank in a step."""

    def fail(*given):
        if sim.steps == number and sim.rank == sim.ranks - 1:
            raise error
        return 0

    return fail


def expected(error, text):
    """What the ranks raise: the last one its own exception, the others one that names it."""
    if not COMM or COMM.rank == RANKS - 1:
        return pytest.raises(error, match=text)
    return pytest.raises(RuntimeError, match=f'rank {RANKS - 1}: {error.__name__}: .*{text}')


def test_errors_of_functions_end_the_run_on_all_ranks():
    sim = thaw.Simulation(drop())
    sim.on_step(raising(sim, 3, KeyError('mine')))
    sim.on_step(lambda s: s.ledger)  # a collective call on all ranks
    with expected(KeyError, 'mine'):
        sim.run()
    assert sim.steps == 3 and not sim.stopped
    assert sim.step()
    sim.on_step(raising(sim, 5, ValueError('second')))
    with expected(ValueError, 'second'):
        sim.step()
    sim.run(steps=2)
    assert sim.steps == 7


def test_errors_on_the_only_rank_with_a_function_reach_all():
    sim = thaw.Simulation(drop())
    if sim.rank == sim.ranks - 1:
        sim.on_step(raising(sim, 2, KeyError('mine')))
    with expected(KeyError, 'mine'):
        sim.run(steps=9)
    assert sim.steps == 2


def test_errors_between_collective_calls_reach_all():
    sim = thaw.Simulation(drop())

    def two_sums(s):
        s.ledger
        if s.steps == 2 and s.rank == s.ranks - 1:
            raise KeyError('mine')
        s.gather('mass', by='id')

    sim.on_step(two_sums)
    with expected(KeyError, 'mine'):
        sim.run(steps=9)
    assert sim.steps == 2 and sim.ledger['time'] == sim.time


@pytest.mark.skipif(RANKS == 1, reason='one rank alone cannot differ')
def test_different_calls_on_the_ranks_are_refused():
    sim = thaw.Simulation(drop())
    last = sim.rank == sim.ranks - 1
    name = 'mass' if last else 'position'
    with pytest.raises(RuntimeError, match=r"rank \d calls sim.gather\('(position|mass)'\)"):
        sim.gather(name, by='id')
    with pytest.raises(RuntimeError, match='all ranks have to call the same functions'):
        sim.step() if last else sim.ledger
    sim.on_step(lambda s: s.ledger if last else None)
    with pytest.raises(RuntimeError, match='has ended its function without this call'):
        sim.step()


def test_errors_of_forces_are_raised():
    sim = thaw.Simulation(drop())
    with pytest.raises(AttributeError, match="no field 'colour'"):
        sim.add_force(lambda p, t: p.colour)
    sim.run(steps=2)  # the force was not added
    sim.add_force(raising(sim, 4, ZeroDivisionError('late')))
    with expected(ZeroDivisionError, 'late'):
        sim.run(steps=9)
    sim.run(steps=3)
    with pytest.raises(ValueError, match='expected'):
        sim.add_force(lambda p, t: np.zeros((len(p) + 1, 3)))
    assert sim.step()


def test_loads_that_are_not_finite_are_refused():
    sim = thaw.Simulation(drop())
    with pytest.raises((ValueError, RuntimeError), match='not finite'):
        sim.add_force(lambda p, t: np.full((len(p), 3), np.nan))
    with pytest.raises((ValueError, RuntimeError), match='expected an array of numbers'):
        sim.add_force(lambda p, t: None)
    sim.run(steps=2)
    assert np.isfinite(sim.ledger['kinetic'])


def test_a_simulation_that_blew_up_takes_no_further_step():
    sim = thaw.Simulation(drop())
    sim.add_force(lambda p, t: np.full((len(p), 3), 1e30))
    with pytest.raises(thaw.BlewUp, match=r'\(outside 1.73e\+30 N, '):  # not: viscosity
        sim.run(until=1)
    for go in (sim.step, sim.run):
        with pytest.raises(thaw.BlewUp):
            go()


@pytest.mark.skipif(RANKS > 1, reason='mpirun ends all ranks')
def test_an_interrupt_leaves_a_state_that_goes_on():
    sim = thaw.Simulation(drop())
    sim.on_step(lambda s: os.kill(os.getpid(), signal.SIGINT) if s.steps == 2 else None)
    with pytest.raises(KeyboardInterrupt):
        sim.run()
    assert sim.steps == 2
    sim.run(steps=1)
    assert sim.steps == 3


def test_signals_of_batch_systems_stop_all_ranks_with_a_checkpoint(folder):
    sim = thaw.Simulation(drop(), folder)
    steps = []

    def kill(s):
        if s.steps == 3 and s.rank == s.ranks - 1:
            os.kill(os.getpid(), signal.SIGTERM)

    sim.on_step(kill)
    with pytest.raises(KeyboardInterrupt, match='SIGTERM'):
        sim.run()
    steps.append(sim.steps)
    assert steps[0] in (3, 4)
    sim.close()
    again = thaw.Simulation(drop(), folder, restart=True)
    assert again.steps == steps[0] and again.step()


def test_a_signal_to_one_rank_stops_all_without_functions():
    sim = thaw.Simulation(drop(end=1000, spacing='10 cm'))
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGUSR1))
    if sim.rank == sim.ranks - 1:
        timer.start()
    with pytest.raises(KeyboardInterrupt, match='SIGUSR1'):
        sim.run()
    assert 0 < sim.time < 1000 and not sim.stopped
    assert sim.step()


def test_edits_are_checked():
    sim = thaw.Simulation(plate())
    sim.run(steps=2)
    before = sim.gather('velocity'), sim.gather('temperature')
    with pytest.raises(ValueError, match=r'velocity of row 0 \(id \d+\) is \(nan'):
        with sim.local() as p:
            p.velocity[:1] = np.nan
    with pytest.raises(ValueError, match='is -3 K; expected a finite number of at least 0 K'):
        with sim.local() as p:
            p.temperature[:] = -3
    assert np.array_equal(before[0], sim.gather('velocity'))
    assert np.array_equal(before[1], sim.gather('temperature'))
    assert sim.step()


def test_the_history_is_that_of_the_file(folder):
    sim = thaw.Simulation(drop(output={'every': 0.005}), folder)
    sim.run(until=0.012)
    assert len(sim.history['time']) == 4 and sim.history.units['kinetic'] == 'J'
    sim.finish()
    if sim.rank == 0:
        file, memory = thaw.open(folder).ledger, sim.history
        assert list(file) == list(memory)
        assert all(np.array_equal(file[name], memory[name]) for name in file)
        assert memory['momentum_residual'].shape == (4, 3)
    now, rows = sim.ledger, sim.history
    for name in set(rows) & set(now):
        assert now[name] == rows[name][-1], name
    for axis, name in enumerate('xyz'):
        assert now['momentum_residual_' + name] == rows['momentum_residual'][-1, axis]
    assert {'wall_work', 'entered_mass', 'left_kinetic', 'restart_jump'} <= set(rows) & set(now)


def test_times_that_have_passed_are_refused():
    sim = thaw.Simulation(drop())
    sim.run(until=0.01)
    for until in (-1, 0.005, float('nan')):
        with pytest.raises(ValueError, match='until: expected a time of at least'):
            sim.run(until=until)
    with pytest.raises(ValueError, match='steps: expected'):
        sim.run(steps=-1)


@pytest.mark.skipif(RANKS > 1, reason='one rank shows it')
def test_scene_errors_have_places():
    with pytest.raises(thaw.SceneError) as caught:
        thaw.Simulation(drop(spacing=-1))
    error = caught.value
    assert (error.file, error.line, error.column) == ('scene', 1, 11)
    assert error.message == 'spacing: must be > 0 m, got -1'


@pytest.mark.skipif(RANKS > 1, reason='one rank shows it')
def test_functions_hold_no_simulation():
    sim = thaw.Simulation(drop())
    sim.on_phase('forces', lambda p, t: None)
    sim.on_step(lambda s: None)
    sim.add_force(lambda p, t: 0)
    sim.on_end(lambda s: None)
    end = weakref.ref(sim)
    del sim
    gc.collect()
    assert end() is None


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


# scene -> overrides and number of steps: a few thousand particles in motion
REAL = {
    'dam_break': ({'spacing': 0.03}, 40),
    'melt': (
        {'spacing': 0.009, 'body.bust.temperature': '50 degC', 'body.bust.place.bottom': [0, 0, 0]},
        40,
    ),
    'pour': (
        {
            'spacing': 0.004,
            'emitter.jug.disc.radius': 0.03,
            'emitter.jug.speed': 3,
            'emitter.jug.centre': [0, 0, 0.06],
        },
        150,
    ),
}


@pytest.mark.parametrize('scene', REAL)
def test_same_bits_as_the_command_line(scene, folder):
    file = os.path.join(SCENES, scene + '.toml')
    overrides, steps = REAL[scene]
    sim = thaw.Simulation(file, folder + '/python', set=overrides)
    sim.run(steps=steps)
    now = sim.ledger
    assert now['particles'] > 1500
    assert scene != 'melt' or 0.1 < now['liquid_fraction'] < 0.9
    assert scene != 'dam_break' or now['kinetic'] > 0.1
    sim.finish()
    if sim.rank == 0:
        clean = {k: v for k, v in os.environ.items() if not k.startswith(LAUNCHER)}
        launch = ['mpirun', '-q', '-n', str(RANKS)] if RANKS > 1 else []
        run = [*launch, PROGRAM, 'run', file, '--steps', str(steps), '--out', folder + '/line']
        for key, value in overrides.items():
            run += ['--set', f'{key}={thaw.Scene.toml_value(value)}']
        subprocess.run(run, check=True, env=clean, stdout=subprocess.DEVNULL)
        result = subprocess.run(
            [PROGRAM, 'compare', folder + '/python', folder + '/line'],
            env=clean,
            text=True,
            capture_output=True,
        )
        assert 'equal' in result.stdout, result.stdout + result.stderr
        line, python = (thaw.open(f'{folder}/{name}').ledger for name in ('line', 'python'))
        assert all(np.array_equal(line[name], python[name]) for name in line)
    if COMM:
        COMM.Barrier()


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


def test_extensions_have_fields(folder):
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
    scene['output'] = {'every': 0.005, 'fields': ['dose', 'trace', 'velocity']}
    sim = thaw.Simulation(scene, folder)
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
    frame = thaw.open(folder).frames[-1].fields
    assert frame['dose'][:2] == ('J/kg', 'heat absorbed') and frame['trace'].meaning == ''
    assert frame['velocity'].meaning == 'velocity x, y, z'
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
    assert sim.steps == 1


def test_extensions_that_fail_end_no_interpreter():
    thaw.register_extension(
        'failing',
        {'when': (-1, '', -2, 1e6), 'limit': (1, '', 0, 10)},
        force=lambda p, t, values: 1 / 0 if t >= values['when'] >= 0 else 0,
        step_limit=lambda values: 0.1 / values['limit'],
    )
    with pytest.raises(ZeroDivisionError):
        thaw.Simulation(drop(extension={'failing': {'limit': 0}}))
    with pytest.raises(ZeroDivisionError):
        thaw.Simulation(drop(extension={'failing': {'when': 0}}))
    sim = thaw.Simulation(drop(extension={'failing': {'when': 0.005}}))
    with pytest.raises(ZeroDivisionError):
        sim.run()
    steps, ledger = sim.steps, sim.ledger
    assert steps > 0 and ledger['mass'] > 0
    thaw.register_extension('negative', {}, force=lambda p, t, values: 0, step_limit=lambda values: -1)
    with pytest.raises(ValueError, match="extension 'negative': step_limit returned -1"):
        thaw.Simulation(drop(extension={'negative': {}}))
    thaw.register_extension('limitless', {}, force=lambda p, t, values: 0, step_limit=lambda values: None)
    with pytest.raises(ValueError, match='step_limit returned None; expected seconds above 0'):
        thaw.Simulation(drop(extension={'limitless': {}}))


def test_units_of_extensions_are_those_of_scenes():
    for unit, problem in (('furlong', "unknown unit 'furlong'"), ('mm', 'expected an SI unit')):
        with pytest.raises(ValueError, match=f"'pacer': key 'stride' has the unit '{unit}'.*{problem}"):
            thaw.register_extension('pacer', {'stride': (1, unit)}, force=lambda p, t, values: 0)
    thaw.register_extension(
        'pacer', {'a': (1, 'kg m^2/s'), 'b': (1, '1'), 'c': (1, 'W/(m K)')}, force=lambda p, t, values: 0
    )
    assert thaw.Simulation(drop(extension={'pacer': {'c': '2 mW/(mm K)'}})).step()


def test_a_simulation_without_a_folder_writes_nothing():
    sim = thaw.Simulation(drop())
    for call in ('write_frame', 'write_checkpoint', 'restore'):
        with pytest.raises(RuntimeError, match=f'{call}: the simulation has no folder; give one'):
            getattr(sim, call)()


def test_scenes_have_a_name(folder):
    with thaw.Simulation(thaw.Scene(dict(drop().keys), name=''), folder) as sim:
        assert sim.scene.name == 'scene'
    assert thaw.open(folder).frames[0].path.endswith('frames/scene_000000.hdf')


def test_errors_list_offered_fields_only():
    sim = thaw.Simulation(plate())
    with sim.local('solids') as p, pytest.raises(thaw.FieldError, match='There are: ') as error:
        p['colour']
    listed = set(str(error.value).split('There are: ')[1].rstrip('.').split(', '))
    assert listed == set(sim.fields('solids')) and 'volume' in listed
    offered = listed | set(sim.fields())
    assert not offered & {'slot', 'cell', 'frame', 'just_frozen', 'particle', 'end', 'end_double', 'changed'}


def test_a_refused_restart_ends_no_interpreter(folder):
    thaw.register_extension('still', {'k': 1}, force=lambda p, t, values: 0)
    with thaw.Simulation(drop(extension={'still': {}}), folder) as sim:
        sim.run(steps=2)
        sim.finish()
    with pytest.raises(thaw.SceneError, match='spacing'):
        thaw.Simulation(drop(extension={'still': {}}, spacing='6 cm'), folder, restart=True)
