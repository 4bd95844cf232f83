#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A pile of rigid pieces (core/rigid/contact/) has the same bits on 1, 2, 3, 4 and 7 ranks, and when the run
# is stopped and resumed on other ranks. Boxes and balls fall upon each other in a bin.
. "$(dirname "$0")/../support/run.sh"
scene=pile
cat >"$work/$scene.toml" <<'SCENE'
spacing = 0.1
end = 1
[domain]
min = [-0.9, -0.9, 0]
max = [0.9, 0.9, 3]
sides = { x = "wall", y = "wall", z = "wall" }
gravity = [0, 0, -9.81]
[material.stone]
law = "rigid"
density = 2500
friction = 0.4
rolling_friction = 0.01
restitution = 0.2
[numerics]
max_step = 0.002
sleep_speed = 0.05
sleep_after = 0.02
[output]
every = 0.05
SCENE
for k in $(seq 0 44); do
  shape="box = { size = [0.4, 0.3, 0.3] }"
  [ $((k % 2)) -eq 0 ] || shape="sphere = { radius = 0.2 }"
  place="$((k % 3 * 6 - 6))e-1, $((k / 3 % 3 * 6 - 6))e-1, $((3 + k / 9 * 5))e-1"
  cat >>"$work/$scene.toml" <<BODY
[[body]]
name = "piece $k"
material = "stone"
$shape
velocity = [0, 0, -3]
place = { move = [$place], rotate_x = $((k * 3 % 7))e-1 }
BODY
done
sameOnAllRanks $scene 90 "30 60" "$work/$scene.toml"
finish
