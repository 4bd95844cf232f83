# SPDX-License-Identifier: Apache-2.0
"""A heat lamp with a controller: it warms the top of a block of wax to a set point, and holds it there.

lamp.py [PICTURE.png]     mpirun -n 2 python3 lamp.py works too
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


class Controller:
    """Power (W) from the error of a temperature (K), proportional and integral, between 0 and `most`."""

    def __init__(self, target, proportional, integral, most):
        self.target, self.proportional, self.integral, self.most = target, proportional, integral, most
        self.power, self.sum = 0.0, 0.0

    def advance(self, temperature, dt):
        error = self.target - temperature
        wanted = self.proportional * error + self.integral * (self.sum + error * dt)
        self.power = min(max(wanted, 0.0), self.most)
        if wanted == self.power:  # anti-windup: the integral is frozen while the power is at a limit
            self.sum += error * dt


def main():
    sim = thaw.Simulation(
        thaw.Scene(
            spacing='2 cm',
            end='4 s',
            domain={'min': [-0.2, -0.2, 0], 'max': [0.2, 0.2, 0.4], 'gravity': [0, 0, 0]},
            material={
                'wax': {
                    'density': 900,
                    'young': '20 kPa',
                    'conductivity': '300 W/(m K)',
                    'heat_capacity': '2 kJ/(kg K)',
                }
            },
            body=[
                {
                    'name': 'block',
                    'box': {'size': [0.16, 0.16, 0.16]},
                    'place': {'bottom': [0, 0, 0]},
                    'material': 'wax',
                    'temperature': '20 degC',
                }
            ],
            obstacle=[
                {
                    'name': 'table',
                    'plane': {'point': [0, 0, 0], 'normal': [0, 0, 1]},
                    'temperature': '20 degC',
                }
            ],
        )
    )
    lamp = Controller(target=313.15, proportional=6000.0, integral=4000.0, most=30e3)
    times, temperatures, powers = [], [], []

    def lit(p):
        return p.position[:, 2] > 0.12

    def heat(p, t):
        """Shares the power among the lit particles: W, shape (n,)."""
        return lamp.power * lit(p) / max(1, total(int(lit(p).sum())))

    def control(sim):
        with sim.local() as p:
            top = lit(p)
            mean = total(float(p.temperature[top].sum())) / max(1, total(int(top.sum())))
            del top
        lamp.advance(mean, sim.last_step)
        times.append(sim.time)
        temperatures.append(mean - 273.15)
        powers.append(lamp.power)

    sim.add_heat(heat)
    sim.on_step(control)
    sim.run()
    late = np.array(times) > 0.7 * sim.end
    if sim.rank > 0:
        return
    error = abs(np.array(temperatures)[late] - 40).max()
    print(f'{sim.steps} steps; at the end within {error:.2f} K of the set point')
    print(f'power from {powers[0]:.0f} W at the start to {powers[-1]:.0f} W')
    if len(sys.argv) > 1:
        plot(times, temperatures, powers, sys.argv[1])


def plot(times, temperatures, powers, picture):
    import matplotlib

    matplotlib.use('Agg')
    import matplotlib.pyplot as plt

    figure, (upper, lower) = plt.subplots(2, 1, sharex=True, figsize=(5, 4), layout='constrained')
    upper.axhline(40, color='#bbbbbb', lw=1)
    upper.plot(times, temperatures, color='#b5472f')
    upper.set_ylabel('top of the block / \u00b0C')
    lower.plot(times, powers, color='#3b6ea5')
    lower.set_ylabel('power of the lamp / W')
    lower.set_xlabel('time / s')
    figure.savefig(picture, dpi=110)


if __name__ == '__main__':
    main()
