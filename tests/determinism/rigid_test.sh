#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Rigid pieces (core/rigid/) have the same bits on 1, 2, 3, 4 and 7 ranks, and when the run is stopped and
# resumed on another number of ranks. Blocks fall into hot wax, touch, melt, and freeze again.
. "$(dirname "$0")/../support/run.sh"
scene=wax_pieces
cat >"$work/$scene.toml" <<'SCENE'
spacing = 0.05
end = 1
[domain]
min = [-0.5, -0.5, -0.2]
max = [0.5, 0.5, 1]
sides = { x = "wall", y = "wall", z = "wall" }
gravity = [0, 0, -9.81]
[material.wax]
law = "rigid"
density = 900
viscosity = 5
sound_speed = 40
conductivity = 2e4
heat_capacity = 2000
latent_heat = 3e4
melts = [313, 338]
hysteresis = 0.3
[[body]]
name = "melt"
material = "wax"
temperature = 420
box = { size = [1, 1, 0.15] }
place = { move = [0, 0, -0.125] }
[[body]]
name = "plate"
material = "wax"
temperature = 327
box = { size = [0.7, 0.3, 0.1] }
[[body]]
name = "bar"
material = "wax"
temperature = 305
box = { size = [0.2, 0.7, 0.15] }
place = { move = [0, 0, 0.125] }
[[body]]
name = "block"
material = "wax"
temperature = 290
spin = [3, 1, 2]
box = { size = [0.2, 0.2, 0.15] }
place = { move = [0.25, 0.15, 0.175] }
[[thermostat]]
start = 0.03
over = 0.01
temperature = 300
[numerics]
retry_every = 10
[output]
every = 0.01
SCENE
same() { sameRuns "$1" "$2" "$3" "frames/wax_pieces.hdf.series"; }
sameOnAllRanks $scene 60 "15 33 48" "$work/$scene.toml"
for count in melted frozen; do
  [ "$(value "$work/$scene.1/summary.json" $count)" -gt 0 ] || fail "$scene: nothing $count"
done
# Strong coupling to the incompressible and the implicit viscosity solver
sameOnAllRanks ${scene}_solvers 24 "9 16" "$work/$scene.toml" --set numerics.pressure_solver=incompressible \
  --set numerics.viscosity_solver=implicit --set numerics.max_step=0.002
# A clamped ball is partly liquid. It stops as its piece is made at the start, and viscosity reads its ghosts.
cat >"$work/mushy.toml" <<'SCENE'
spacing = 0.01
end = 1
[domain]
min = [-0.13, -0.13, 0]
max = [0.13, 0.13, 0.6]
sides = { x = "wall", y = "wall", z = ["wall", "open"] }
[material.wax]
law = "rigid"
density = 240
viscosity = 27
heat_capacity = 2800
conductivity = 1
melts = [300, 320]
latent_heat = 2e4
hysteresis = 0.14
[material.liquid]
density = 1000
viscosity = 0.1
[[body]]
name = "ball"
material = "wax"
temperature = 303
spin = [0, 26, 32]
sphere = { radius = 0.04 }
place = { move = [-0.03, -0.04, 0.42] }
clamp = [{ sphere = { radius = 0.02 }, place = { move = [-0.03, -0.04, 0.42] } }]
[[body]]
name = "pool"
material = "liquid"
box = { size = [0.26, 0.26, 0.03] }
place = { move = [0, 0, 0.015] }
[output]
every = 0.01
SCENE
same() { sameRuns "$1" "$2" "$3" "frames/mushy.hdf.series"; }
sameOnAllRanks mushy 12 "4 8" "$work/mushy.toml"
finish
