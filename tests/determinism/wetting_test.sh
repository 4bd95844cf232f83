#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A drop that wets one wall and beads on another, melts a solid into itself and has a tension by temperature
# has the same bits on 1, 2, 3, 4 and 7 ranks and over a restart. Liquid leaves through an open side, and an
# obstacle moves and vanishes. Without the keys the modules are off.
. "$(dirname "$0")/../support/run.sh"
cat >"$work/wet.toml" <<'T'
title   = "Drops on walls"
spacing = "1 mm"
end     = "1 s"

[domain]
min     = [-0.02, -0.02, -0.005]
max     = [0.02, 0.02, 0.03]

[output]
every  = 0.02
fields = ["velocity", "temperature", "liquid"]

[material.wax]
density         = 900
young           = "20 kPa"
melts           = [320, 330]
heat_capacity   = 500
conductivity    = 20
viscosity       = 0.01
surface_tension = [[310, "60 mN/m"], [400, "20 mN/m"]]
contact_angle   = "40 deg"

[[body]]
name        = "drop"
sphere      = { radius = "7 mm" }
place       = { move = [0.002, 0, 0.0075] }
material    = "wax"
temperature = 350
velocity    = [0.6, 0, -0.2]
packing     = "relaxed"

[[body]]
name        = "lump"
box         = { size = [0.006, 0.006, 0.006] }
place       = { bottom = [-0.012, 0, 0] }
material    = "wax"
temperature = 300

[[obstacle]]
name        = "plate"
plane       = { point = [0, 0, 0], normal = [0, 0, 1] }
temperature = 380

[[obstacle]]
name          = "piston"
box           = { size = [0.006, 0.03, 0.03] }
place         = { bottom = [0.016, 0, -0.001] }
contact_angle = "130 deg"
until         = "35 ms"
motion        = [{ time = 0, move = [0, 0, 0] }, { time = 1, move = [-0.02, 0, 0] }]
T
sameOnAllRanks wet 75 "25 50" "$work/wet.toml"
sameOnAllRanks curvature 45 "15 30" "$work/wet.toml" --set 'numerics.tension="curvature"'
finish
