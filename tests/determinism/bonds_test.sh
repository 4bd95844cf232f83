#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Bonds that form during the run, by freezing onto a solid and by welding, are the same on any number of
# ranks.
. "$(dirname "$0")/../support/run.sh"
cat >"$work/weld.toml" <<'SCENE'
title   = "Two blocks collide and weld"
spacing = "1 cm"
end     = "1 s"
[domain]
min     = [-0.3, -0.3, -0.3]
max     = [ 0.3,  0.3,  0.3]
gravity = [0, 0, 0]
[material.clay]
density = 1000
young   = "100 kPa"
poisson = 0.3
damping = "5 1/s"
weld    = true
[[body]]
name     = "left"
material = "clay"
box      = { size = [0.06, 0.06, 0.06] }
place    = { move = [-0.04, 0, 0] }
velocity = [1, 0, 0]
[[body]]
name     = "right"
material = "clay"
box      = { size = [0.06, 0.06, 0.06] }
place    = { move = [0.04, 0.013, 0] }
velocity = [-1, 0, 0]
SCENE
# try NAME SCENE STEPS COUNTER: the counter of the summary must not be 0
try() {
  local name=$1 scene=$2 steps=$3 counter=$4
  sameOnAllRanks "$name" "$steps" - "$scene" "${set[@]}"
  grep -Eq "\"$counter\": *[1-9]" "$work/$name.1/summary.json" || fail "$name: nothing has $counter"
}
set=()
try weld "$work/weld.toml" 200 welds
settings freeze
try freeze "$scenes/freeze.toml" 900 frozen
finish
