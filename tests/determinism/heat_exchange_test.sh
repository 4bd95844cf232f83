#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Contact conductance, evaporation and mush have the same bits on 1, 2, 3, 4 and 7 ranks, and when the run is
# stopped and resumed on another number of ranks. A melt boils away in a cold mould and freezes on it.
. "$(dirname "$0")/../support/run.sh"
scene=boiling_melt
cat >"$work/$scene.toml" <<'SCENE'
spacing = 0.02
end = 1
[domain]
min = [-0.2, -0.2, 0]
max = [0.2, 0.2, 0.4]
sides = { z = ["wall", "open"] }
[material.metal]
young = "50 kPa"
density = 2000
viscosity = 0.5
sound_speed = 20
surface_tension = 1
conductivity = 2e4
heat_capacity = 500
latent_heat = 2e4
melts = [600, 640]
hysteresis = 0.3
contact_conductance = 1e6
evaporation = [[610, 0], [645, 20000]]
evaporation_heat = 1e4
mush_drag = 1e5
[material.mould]
young = "80 kPa"
density = 1500
conductivity = 2e4
heat_capacity = 800
contact_conductance = 5e5
[[body]]
name = "mould"
material = "mould"
temperature = 200
box = { size = [0.28, 0.28, 0.06] }
place = { move = [0, 0, 0.03] }
[[body]]
name = "melt"
material = "metal"
temperature = 650
velocity = [0.5, 0.2, 0]
box = { size = [0.16, 0.16, 0.16] }
place = { move = [0, 0, 0.15] }
[numerics]
retry_every = 10
[output]
every = 0.01
fields = ["temperature", "liquid", "velocity"]
SCENE
same() { sameRuns "$1" "$2" "$3" ledger.csv; }
sameOnAllRanks $scene 120 "37 61 90" "$work/$scene.toml"
summary=$work/$scene.1/summary.json
[ "$(value "$summary" evaporated)" -gt 0 ] || fail "$scene: no particle left as vapour"
[ "$(value "$summary" frozen)" -gt 0 ] || fail "$scene: nothing froze"
for module in "contact conductance" evaporation "mush drag"; do
  grep -q "\"$module: " "$summary" || fail "$scene: no module '$module'"
done
finish
