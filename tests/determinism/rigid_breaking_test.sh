#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Rigid pieces break in impacts (core/rigid/breaking/) and fall asleep (core/rigid/sleeping_pieces.hpp). They
# have the same bits on 1, 2, 3, 4 and 7 ranks, and when the run is stopped and resumed on other ranks. A bar
# falls on a ridge beside a sleeping block, and its parts hit the floor and the block.
. "$(dirname "$0")/../support/run.sh"
scene=bar_on_ridge
cat >"$work/$scene.toml" <<'SCENE'
spacing = 0.1
end = 2
[domain]
min = [-1.5, -0.5, -0.5]
max = [1.5, 0.5, 1]
sides = { x = "wall", y = "wall", z = "wall" }
gravity = [0, 0, -9.81]
[material.glass]
law = "rigid"
density = 2500
young = "70 GPa"
strength = "40 MPa"
restitution = 0.2
[[body]]
name = "bar"
material = "glass"
box = { size = [2, 0.2, 0.2] }
place = { move = [0.1, 0.1, 0.2] }
velocity = [0, 0, -6]
spin = [0, 0.2, 0]
[[body]]
name = "block"
material = "glass"
box = { size = [0.4, 0.4, 0.4] }
place = { move = [-0.8, 0, -0.3] }
[[obstacle]]
name = "ridge"
box = { size = [0.2, 1, 0.5] }
place = { move = [0, 0, -0.2] }
[numerics]
max_step = 0.002
sleep_speed = 0.05
sleep_after = 0.01
retry_every = 10
[output]
every = 0.02
SCENE
sameOnAllRanks $scene 50 "10 30" "$work/$scene.toml"
[ "$(value "$work/$scene.1/summary.json" broken_pieces)" -gt 0 ] || fail "$scene: nothing broke"
# The parts of the bar wake the block after step 8.
launch 1 run "$work/$scene.toml" --steps 8 --out "$work/early" >"$work/log" 2>&1
[ "$(value "$work/early/summary.json" asleep)" -gt 0 ] || fail "$scene: nothing slept"
finish
