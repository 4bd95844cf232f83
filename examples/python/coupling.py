# SPDX-License-Identifier: Apache-2.0
"""Couples a rigid pendulum outside of thaw with water, in both directions in each step.

coupling.py [END] [PICTURE.png]     mpirun -n 3 python3 coupling.py works too; END in s, default 1.5

The ball of the pendulum is an obstacle with one keyframe. The program moves it, and reads the force of the
water on it.
"""
import sys

import numpy as np

import thaw


class Pendulum:
    """A ball on a rigid, massless rod in the plane y = 0. It stands for another program."""

    radius, mass, rod = 0.1, 8.0, 0.5  # m, kg, m
    pivot = np.array([0, 0, 0.62])  # m

    def __init__(self, angle):
        self.angle, self.rate = angle, 0.0  # rad from below, rad/s

    @property
    def place(self):
        return self.pivot + self.rod * np.array([np.sin(self.angle), 0, -np.cos(self.angle)])

    @property
    def along(self):
        """Direction of motion for a growing angle."""
        return np.array([np.cos(self.angle), 0, np.sin(self.angle)])

    @property
    def velocity(self):
        return self.rod * self.rate * self.along

    def energy(self):
        return self.mass * (0.5 * (self.rod * self.rate) ** 2 + 9.81 * self.place[2])

    def kick(self, force, dt):
        force = force + [0, 0, -9.81 * self.mass]
        self.rate += dt * (force @ self.along) / (self.mass * self.rod)

    def drift(self, dt):
        self.angle += dt * self.rate


def sceneOf(start, end):
    return thaw.Scene(
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
                'box': {'size': [1.2, 0.4, 0.2]},
                'place': {'bottom': [0, 0, 0]},
                'material': 'water',
            }
        ],
        obstacle=[
            {
                'name': 'ball',
                'sphere': {'radius': Pendulum.radius},
                'motion': [{'time': 0, 'move': start.tolist()}],
            }
        ],
    )


def main():
    end = float(sys.argv[1]) if len(sys.argv) > 1 else 1.5
    pendulum = Pendulum(angle=1.2)
    sim = thaw.Simulation(sceneOf(pendulum.place, end))
    ball = sim.obstacles['ball']
    start, times, angles, forces = pendulum.energy(), [], [], []

    def couple(sim):
        """Kick and drift of the pendulum over the last step, then its motion in the next one."""
        pendulum.drift(sim.last_step)
        force = ball.force
        pendulum.kick(force, sim.last_step)
        ball.move(pendulum.place, pendulum.velocity)
        times.append(sim.time)
        angles.append(np.degrees(pendulum.angle))
        forces.append(force)

    sim.on_step(couple)
    sim.run()
    lost, ledger = start - pendulum.energy(), sim.ledger
    if sim.rank > 0:
        return
    print(f'angle {angles[-1]:.12g} degrees after {sim.steps} steps')
    print(f'the pendulum lost {lost:.2f} J; the water received {ledger["outside_work"]:.2f} J of work')
    if len(sys.argv) > 2:
        plot(times, angles, np.array(forces), sys.argv[2])


def plot(times, angles, forces, picture):
    import matplotlib

    matplotlib.use('Agg')
    import matplotlib.pyplot as plt

    figure, (upper, lower) = plt.subplots(2, 1, sharex=True, figsize=(5, 4), layout='constrained')
    upper.plot(times, angles, color='#3b6ea5')
    upper.set_ylabel('angle / degrees')
    lower.plot(times, forces[:, 0], color='#b5472f', lw=0.8, label='x')
    lower.plot(times, forces[:, 2], color='#777777', lw=0.8, label='z')
    lower.set_ylabel('force of the water / N')
    lower.set_xlabel('time / s')
    lower.legend(frameon=False)
    figure.savefig(picture, dpi=110)


if __name__ == '__main__':
    main()
