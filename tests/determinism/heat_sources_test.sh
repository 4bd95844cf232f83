#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Lamps, lasers and heated regions (core/heat/sources/) have the same bits on 1, 2, 3, 4 and 7 ranks. A stop
# that another number of ranks resumes does not change them. Wax melts under light from everywhere, in the
# shadow of a turning obstacle and of a falling block.
. "$(dirname "$0")/../support/run.sh"
scene=lit_wax
cat >"$work/$scene.toml" <<'SCENE'
spacing = 0.05
end = 1
[domain]
min = [-0.5, -0.5, -0.25]
max = [0.5, 0.5, 1]
sides = { x = "wall", y = "wall", z = "wall" }
[material.wax]
young = { solid = "200 kPa", liquid = 0 }
density = 900
viscosity = 5
sound_speed = 20
conductivity = 200
heat_capacity = 2000
latent_heat = 3e4
melts = [313, 338]
absorptivity = 0.7
[[body]]
name = "slab"
material = "wax"
temperature = 312
box = { size = [0.8, 0.8, 0.2] }
place = { move = [0, 0, -0.15] }
[[body]]
name = "block"
material = "wax"
temperature = 330
box = { size = [0.2, 0.2, 0.2] }
place = { move = [0.13, 0.1, 0.2] }
[[obstacle]]
name = "shutter"
box = { size = [0.3, 0.2, 0.03] }
place = { move = [-0.2, 0, 0.5] }
motion = [{ time = 0 }, { time = 0.1, rotate = [0, 0, 1] }]
[[lamp]]
name = "bulb"
power = "2 MW"
position = [-0.2, 0.1, 0.9]
[[lamp]]
name = "sun"
kind = "direction"
irradiance = "1 MW/m^2"
direction = [0.3, 0.2, -1]
[[lamp]]
name = "window"
kind = "area"
power = "1 MW"
position = [0.3, 0.3, 0.8]
direction = [-0.3, -0.2, -1]
width = 0.2
depth = 0.3
end = 0.02
[[laser]]
power = "1 MW"
radius = 0.06
position = [-0.3, -0.2, 0]
motion = [{ time = 0 }, { time = 0.1, move = [0.5, 0.3, 0] }]
[[laser]]
power = "1 MW"
radius = 0.06
absorption_depth = 0.08
position = [0.2, -0.2, 0]
direction = [0.2, 0, -1]
start = 0.002
[[heated_region]]
power = "1 MW"
material = "wax"
sphere = { radius = 0.15 }
place = { move = [0.2, 0.2, -0.2] }
motion = [{ time = 0 }, { time = 0.1, move = [-0.5, 0, 0] }]
[numerics]
retry_every = 10
[output]
every = 0.005
fields = ["temperature", "liquid", "absorbed"]
SCENE
same() { sameRuns "$1" "$2" "$3" "frames/$scene.hdf.series"; }
sameOnAllRanks $scene 90 "23 46 70" "$work/$scene.toml"
[ "$(value "$work/$scene.1/summary.json" melted)" -gt 0 ] || fail "$scene: nothing melted"
finish
