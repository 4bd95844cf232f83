# SPDX-License-Identifier: Apache-2.0
"""Couples a pendulum with water: in each step, each acts on the other.

coupling.py [END]     mpirun -n 3 python3 coupling.py works too; END in s, default 1
"""
import sys

import numpy as np

import thaw

try:
    from mpi4py import MPI

    total = MPI.COMM_WORLD.allreduce
except ImportError:

    def total(value):
        return value


class Pendulum:
    """A ball on a rigid, massless rod in the plane y = 0. It stands for another program."""

    radius, mass, rod = 0.12, 12.0, 0.5  # m, kg, m
    pivot = np.array([0, 0, 0.62])  # m
    stiffness = 4e4  # N/m, of the layer in which the ball repels particles

    def __init__(self):
        self.angle, self.rate = 1.2, 0.0  # rad from below, rad/s
        self.push = np.zeros(3)  # N, force of the water on the ball

    @property
    def place(self):
        return self.pivot + self.rod * np.array([np.sin(self.angle), 0, -np.cos(self.angle)])

    @property
    def along(self):
        """Direction of motion for a growing angle."""
        return np.array([np.cos(self.angle), 0, np.sin(self.angle)])

    def energy(self):
        return self.mass * (0.5 * (self.rod * self.rate) ** 2 + 9.81 * self.place[2])

    def advance(self, dt):
        force = self.push + [0, 0, -9.81 * self.mass]
        self.rate += dt * (force @ self.along) / (self.mass * self.rod)
        self.angle += dt * self.rate


def main():
    end = float(sys.argv[1]) if len(sys.argv) > 1 else 1.0
    ball = Pendulum()
    sim = thaw.Simulation(
        thaw.Scene(
            spacing='4 cm',
            end=end,
            domain={
                'min': [-0.6, -0.2, 0],
                'max': [0.6, 0.2, 1.2],
                'sides': {'x': 'wall', 'y': 'wall', 'z': 'wall'},
            },
            material={'water': {'density': 1000, 'viscosity': 1, 'sound_speed': 25}},
            body=[
                {
                    'name': 'pool',
                    'box': {'size': [1.2, 0.4, 0.2]},
                    'place': {'bottom': [0, 0, 0]},
                    'material': 'water',
                }
            ],
            numerics={'max_step': 2e-4},  # the automatic step does not consider the spring
        )
    )

    def repel(p, time):
        """Pushes particles out of the ball by a spring, and sums the reaction over all ranks."""
        away = p.position - ball.place
        distance = np.linalg.norm(away, axis=1)
        depth = np.maximum(0, ball.radius - distance)
        forces = ball.stiffness * 0.04 * (depth / np.maximum(distance, 1e-9))[:, None] * away
        ball.push = -total(forces.sum(axis=0))
        return forces

    sim.add_force(repel)
    sim.on_step(lambda sim: ball.advance(sim.last_step))
    start, lost = ball.energy(), 0.0
    while sim.time < end and sim.step():
        if sim.steps % 500 == 0 and sim.rank == 0:
            print(f't {sim.time:.3f} s: angle {np.degrees(ball.angle):.1f} deg, force {ball.push.round(1)} N')
    lost = start - ball.energy()
    ledger = sim.ledger
    if sim.rank == 0:
        print(f'the pendulum lost {lost:.2f} J; the water received {ledger["outside_work"]:.2f} J of work')


if __name__ == '__main__':
    main()
