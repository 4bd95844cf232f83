#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Materials whose solid and liquid differ in density have the same bits on 1, 2, 3, 4 and 7 ranks, and over a
# restart: rigid ice melts in water while elastic wax freezes and melts, with either pressure solver.
. "$(dirname "$0")/../support/run.sh"
cat >"$work/phases.toml" <<'SCENE'
spacing = 0.05
end = 1
[domain]
min = [-0.5, -0.5, -0.2]
max = [0.5, 0.5, 1]
sides = { x = "wall", y = "wall", z = "wall" }
gravity = [0, 0, -9.81]
[material.ice]
law = "rigid"
density = { solid = 917, liquid = 1000 }
viscosity = 5
sound_speed = 40
conductivity = 2e4
heat_capacity = 2000
latent_heat = 3e4
melts = [313, 338]
hysteresis = 0.3
[material.wax]
young = "300 kPa"
law = "neo-hookean"
density = { solid = 900, liquid = 780 }
viscosity = 5
sound_speed = 40
conductivity = 2e4
heat_capacity = 2000
latent_heat = 3e4
melts = [313, 338]
hysteresis = 0.3
[[body]]
name = "melt"
material = "ice"
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
material = "ice"
temperature = 305
box = { size = [0.2, 0.7, 0.15] }
place = { move = [0, 0, 0.125] }
[[body]]
name = "block"
material = "wax"
temperature = 345
box = { size = [0.2, 0.2, 0.15] }
place = { move = [0.25, 0.15, 0.175] }
[[thermostat]]
start = 0.03
over = 0.01
temperature = 300
[numerics]
retry_every = 10
max_step = 0.002
[output]
every = 0.01
SCENE
same() { sameRuns "$1" "$2" "$3" "frames/phases.hdf.series"; }
sameOnAllRanks carried 60 "15 33 48" "$work/phases.toml"
for count in melted frozen; do
  [ "$(value "$work/carried.1/summary.json" $count)" -gt 0 ] || fail "nothing $count"
done
sameOnAllRanks summed 40 "20" "$work/phases.toml" --set numerics.density=summation
sameOnAllRanks incompressible 24 "9 16" "$work/phases.toml" --set numerics.pressure_solver=incompressible
finish
