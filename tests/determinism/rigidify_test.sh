#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Rigid parts of elastic solids (core/rigid/rigidify/) have the same bits on 1, 2, 3, 4 and 7 ranks, and when
# the run is stopped and resumed on another number of ranks. Blocks of wax fall, touch, melt, and freeze
# again.
. "$(dirname "$0")/../support/run.sh"
scene=rigid_parts
cat >"$work/$scene.toml" <<'SCENE'
spacing = 0.05
end = 2
[domain]
min = [-0.6, -0.6, -0.2]
max = [0.6, 0.6, 1.5]
sides = { x = "wall", y = "wall", z = "wall" }
gravity = [0, 0, -9.81]
[material.wax]
law = "neo-hookean"
young = 3e5
damping = 20
density = 900
viscosity = 5
sound_speed = 30
conductivity = 1e4
heat_capacity = 2000
latent_heat = 3e4
melts = [313, 338]
hysteresis = 0.3
[[body]]
name = "block"
material = "wax"
temperature = 300
spin = [0.3, 0.2, 0]
box = { size = [0.4, 0.3, 0.6] }
place = { move = [0, 0, 0.32] }
[[body]]
name = "bar"
material = "wax"
temperature = 290
spin = [0, 0.5, 0]
box = { size = [0.3, 0.8, 0.25] }
place = { move = [0.1, 0, 0.9] }
[[obstacle]]
name = "plate"
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
temperature = 500
[[thermostat]]
start = 0.12
over = 0.005
temperature = 300
[numerics]
retry_every = 10
rigidify = 1
sleep_after = 0.01
[output]
every = 0.02
fields = ["velocity", "temperature", "liquid", "stress", "strain"]
SCENE
same() { sameRuns "$1" "$2" "$3" "frames/rigid_parts.hdf.series"; }
# Some particles become elastic in step 104, which ends with a frame. The resumed runs do not have their F.
sameOnAllRanks $scene 260 "60 100 130 200" "$work/$scene.toml"
for count in melted frozen; do
  [ "$(value "$work/$scene.1/summary.json" $count)" -gt 0 ] || fail "$scene: nothing $count"
done
# A body in free fall takes steps longer than the elastic limit, also after a restart.
cat >"$work/fall.toml" <<'SCENE'
spacing = "1 cm"
end = "0.1 s"
[domain]
min = [0, 0, 0]
max = ["12 cm", "12 cm", "26 cm"]
[material.steel]
law = "neo-hookean"
young = "1 GPa"
density = 7800
[[body]]
material = "steel"
box = { size = ["6 cm", "6 cm", "6 cm"] }
place = { bottom = ["6 cm", "6 cm", "8 cm"] }
[numerics]
rigidify = 0.5
[output]
every = 0.01
SCENE
same() { sameRuns "$1" "$2" "$3" "frames/fall.hdf.series"; }
sameOnAllRanks fall 60 "30 45" "$work/fall.toml"
same() { sameRuns "$1" "$2" "$3" "frames/rigid_parts.hdf.series"; }
# Coupling of rigid parts to the incompressible and the implicit viscosity solver
sameOnAllRanks ${scene}_solvers 40 "16 27" "$work/$scene.toml" --set numerics.pressure_solver=incompressible \
  --set numerics.viscosity_solver=implicit
finish
