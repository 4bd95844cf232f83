# SPDX-License-Identifier: Apache-2.0
"""Texts of the scenes of the benchmark of rigid pieces."""
import math

SPACING = 0.1  # m
HEAD = """spacing = {spacing}
end = {end}
[domain]
min = [{low}]
max = [{high}]
gravity = [{gravity}]
[material.stone]
law = "rigid"
density = 2500
friction = {friction}
restitution = {restitution}
rolling_friction = {rolling}
[numerics]
max_step = {step}
sleep_speed = {sleep_speed}
[output]
every = {every}
ledger_every = {ledger_every}
"""
BODY = """[[body]]
name = "{name}"
material = "stone"
{shape}
place = {{ move = [{move}]{turn} }}
velocity = [{velocity}]
spin = [{spin}]
"""
FLOOR = """[[obstacle]]
name = "floor"
plane = {{ point = [0, 0, 0], normal = [0, 0, 1] }}
friction = {friction}
restitution = {restitution}
"""


def numbers(values):
    return ", ".join(f"{v:.12g}" for v in values)


def head(low, high, gravity, **settings):
    values = dict(
        spacing=SPACING,
        end=1,
        friction=0.5,
        restitution=0,
        rolling=0,
        step=1e-3,
        sleep_speed=0,
        every=1,
        ledger_every=0,
    )
    values.update(settings)
    text = HEAD.format(low=numbers(low), high=numbers(high), gravity=numbers(gravity), **values)
    return text, FLOOR.format(friction=values["friction"], restitution=values["restitution"])


def box(name, size, move, velocity=(0, 0, 0), spin=(0, 0, 0), turn=""):
    return BODY.format(
        name=name,
        shape=f"box = {{ size = [{numbers(size)}] }}",
        move=numbers(move),
        velocity=numbers(velocity),
        spin=numbers(spin),
        turn=turn,
    )


def tumbling(end):
    """A box turns about its middle axis, which is unstable."""
    text, _ = head((-2, -2, -2), (2, 2, 2), (0, 0, 0), end=end, every=end, ledger_every=end / 100)
    return text + box("box", (0.6, 0.4, 0.2), (0, 0, 0), spin=(0.01, 3, 0.02))


def incline(friction, angle, end):
    """A box on a floor; gravity is turned by the angle."""
    down = (9.81 * math.sin(angle), 0, -9.81 * math.cos(angle))
    text, floor = head((-2, -2, -1), (14, 2, 2), down, friction=friction, end=end, ledger_every=end)
    return text + floor + box("box", (0.5, 0.5, 0.5), (0, 0, 0.25))


def drop(shape, restitution, end):
    """A box or a ball falls from 1 m upon a floor."""
    text, floor = head(
        (-2, -2, -1), (2, 2, 3), (0, 0, -9.81), restitution=restitution, end=end, ledger_every=1e-3
    )
    body = box("body", (0.6, 0.6, 0.6), (0.01, 0.02, 1.3))
    if shape == "ball":
        body = body.replace("box = { size = [0.6, 0.6, 0.6] }", "sphere = { radius = 0.3 }")
    return text + floor + body


def stack(boxes, sleeps, end):
    text, floor = head(
        (-2, -2, -1),
        (2, 2, 0.5 * boxes + 1),
        (0, 0, -9.81),
        end=end,
        every=end,
        step=2e-3,
        sleep_speed=0.05 if sleeps else 0,
    )
    for k in range(boxes):
        move = (0.01 * (k % 3), 0.01 * (k % 2), 0.25 + 0.5 * k)
        text += box(f"box {k}", (0.5, 0.5, 0.5), move, turn=f", rotate_z = {0.1 * k:.3g}")
    return text + floor


def pile(pieces, end, sleeps):
    """Boxes and balls fall into a bin."""
    across = max(2, round((pieces / 2) ** (1 / 3)))
    half = 0.3 * across + 0.05
    height = 0.6 * math.ceil(pieces / across**2) + 1
    text, floor = head(
        (-half - 0.3, -half - 0.3, -0.3),
        (half + 0.3, half + 0.3, height + 0.5),
        (0, 0, -9.81),
        restitution=0.2,
        friction=0.4,
        rolling=0.01,
        end=end,
        every=end,
        step=2e-3,
        sleep_speed=0.05 if sleeps else 0,
    )
    for name, axis, side in (("low x", 0, 1), ("high x", 0, -1), ("low y", 1, 1), ("high y", 1, -1)):
        point, normal = [0, 0, 0], [0, 0, 0]
        point[axis], normal[axis] = -side * half, side
        floor += (
            FLOOR.format(friction=0.4, restitution=0.2)
            .replace('"floor"', f'"{name}"')
            .replace("[0, 0, 0], normal = [0, 0, 1]", f"{point}, normal = {normal}")
        )
    for k in range(pieces):
        i, j, level = k % across, k // across % across, k // across**2
        move = (0.6 * (i + 0.5) - 0.3 * across, 0.6 * (j + 0.5) - 0.3 * across, 0.4 + 0.6 * level)
        turn = f", rotate_x = {0.3 * k % 6:.3g}, rotate_y = {0.7 * k % 6:.3g}"
        body = box(f"piece {k}", (0.4, 0.3, 0.3), move, turn=turn)
        if k % 2:
            body = body.replace("box = { size = [0.4, 0.3, 0.3] }", "sphere = { radius = 0.2 }")
        text += body
    return text + floor
