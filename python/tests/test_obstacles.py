# SPDX-License-Identifier: Apache-2.0
"""Obstacles that a program moves, and the loads on them."""
from __future__ import annotations

import pathlib

import numpy as np
import pytest

import thaw

try:
    from thaw._load import core

    core()
except ImportError as error:
    pytest.skip(str(error), allow_module_level=True)

SPEED = 0.4  # m/s


def sceneOf(**keys: object) -> thaw.Scene:
    scene = {
        'spacing': '5 cm',
        'end': 0.1,
        'domain': {'min': [-1, -1, -1], 'max': [1, 1, 1]},
        'material': {'water': {'density': 1000, 'viscosity': 1, 'sound_speed': 20}},
        'body': [{'sphere': {'radius': 0.2}, 'place': {'move': [0, 0, 0.2]}, 'material': 'water'}],
        'obstacle': [
            {
                'name': 'plate',
                'box': {'size': [1, 1, 0.2]},
                'place': {'move': [0, 0, -0.1]},
                'motion': [{'time': 0}],
            },
            {'name': 'floor', 'plane': {'point': [0, 0, -0.5], 'normal': [0, 0, 1]}},
        ],
    }
    return thaw.Scene({**scene, **keys})


def lift(sim: thaw.Simulation) -> thaw.DrivenObstacle:
    """Moves the plate upwards, from the present time on."""
    plate = sim.obstacles['plate']

    def move(sim: thaw.Simulation) -> None:
        plate.move([0, 0, SPEED * sim.time], [0, 0, SPEED])

    move(sim)
    sim.on_step(move)
    return plate


def test_obstacles_are_a_mapping_with_loads() -> None:
    sim = thaw.Simulation(sceneOf())
    assert list(sim.obstacles) == ['plate', 'floor'] and len(sim.obstacles) == 2
    plate = lift(sim)
    assert sim.obstacles['plate'] is plate and (plate.force == 0).all()
    sim.run(steps=30)
    assert plate.force.shape == plate.torque.shape == (3,) and plate.force[2] < -1
    assert plate.position[2] == pytest.approx(SPEED * sim.time)
    assert plate.velocity == pytest.approx([0, 0, SPEED]) and 'plate at' in repr(plate)


def test_move_keeps_what_is_not_given() -> None:
    plate = thaw.Simulation(sceneOf()).obstacles['plate']
    plate.move([0, 0, -0.2], rotation=[0, 0, 0.5])
    plate.move(velocity=[1, 0, 0])
    assert plate.position.tolist() == [0, 0, -0.2] and plate.rotation.tolist() == [0, 0, 0.5]
    assert plate.velocity == pytest.approx([1, 0, 0])


def test_what_cannot_be_driven_is_refused() -> None:
    sim = thaw.Simulation(sceneOf())
    with pytest.raises(KeyError, match="unknown obstacle 'lid'; the scene has 'plate', 'floor'"):
        sim.obstacles['lid']
    with pytest.raises(ValueError, match="'floor' is static: give it a keyframe"):
        sim.obstacles['floor']
    with pytest.raises(ValueError, match='must be finite'):
        sim.obstacles['plate'].move(velocity=[np.nan, 0, 0])


def test_a_restart_continues_with_the_same_bits(tmp_path: pathlib.Path) -> None:
    """The program calls move() before the first step after the restart."""
    whole = thaw.Simulation(sceneOf())
    plate = lift(whole)
    whole.run(steps=40)

    out = str(tmp_path / 'run')
    first = thaw.Simulation(sceneOf(), out)
    lift(first)
    first.run(steps=20)
    first.write_checkpoint()
    first.close()
    second = thaw.Simulation(sceneOf(), out, restart=True)
    other = lift(second)
    second.run(steps=20)
    assert second.steps == 40 and second.time == whole.time
    for field in ('position', 'velocity'):
        assert (second.gather(field) == whole.gather(field)).all()
    assert (other.force == plate.force).all() and (other.torque == plate.torque).all()
