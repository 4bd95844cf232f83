#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Rigid pieces that weld (core/rigid/welding/) have the same bits on 1, 2, 3, 4 and 7 ranks, and when the run
# is stopped and resumed on other ranks. Hot bars fall upon each other, break, and weld.
. "$(dirname "$0")/../support/run.sh"
scene=hot_bars
cat >"$work/$scene.toml" <<'SCENE'
spacing = 0.1
end = 2
[domain]
min = [-1.5, -1, -0.5]
max = [1.5, 1, 1.5]
sides = { x = "wall", y = "wall", z = "wall" }
gravity = [0, 0, -9.81]
[material.iron]
law = "rigid"
density = 7800
young = "70 GPa"
strength = "100 MPa"
weld_temperature = 1000
heat_capacity = 450
conductivity = 50
restitution = 0.1
[[body]]
name = "long"
material = "iron"
temperature = 1200
box = { size = [2, 0.2, 0.2] }
place = { move = [0.1, 0.1, 0.2] }
velocity = [0, 0, -6]
[[body]]
name = "across"
material = "iron"
temperature = 1100
box = { size = [0.3, 1.2, 0.2] }
place = { move = [0.6, 0.05, 0.6], rotate_z = 0.3 }
velocity = [0, 0, -6]
[[body]]
name = "cold"
material = "iron"
temperature = 900
box = { size = [0.3, 0.3, 0.3] }
place = { move = [-0.7, 0, 0.7], rotate_x = 0.2 }
velocity = [0, 0, -4]
[[obstacle]]
name = "ridge"
box = { size = [0.2, 1, 0.5] }
place = { move = [0, 0, -0.2] }
[numerics]
max_step = 0.002
retry_every = 10
[output]
every = 0.02
SCENE
# The run stops just before and just after the first weld.
before=0 after=120
while [ $((after - before)) -gt 1 ]; do
  middle=$(((before + after) / 2))
  launch 1 run "$work/$scene.toml" --steps $middle --out "$work/to.$middle" >"$work/log" 2>&1
  expectExit 0 "$scene, to step $middle"
  welded=$(value "$work/to.$middle/summary.json" welded_pieces)
  if [ "$welded" -gt 0 ]; then after=$middle; else before=$middle; fi
done
sameOnAllRanks $scene 120 "$before $after" "$work/$scene.toml"
for count in broken_pieces welded_pieces; do
  [ "$(value "$work/$scene.1/summary.json" $count)" -gt 0 ] || fail "$scene: no $count"
done
finish
