#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Overlapping bodies that share a lattice (core/domain/body_lattices.hpp), at a spacing that fits none of
# them, have the same bits on 1, 2, 3, 4 and 7 ranks and over restarts.
. "$(dirname "$0")/../support/run.sh"
scene=tub
cat >"$work/tub.toml" <<'SCENE'
spacing = "11.3 mm"
end = 1
[domain]
min = [0, 0, 0]
max = [0.3, 0.3, 0.3]
sides = { x = "periodic", y = "wall", z = "wall" }
[material.water]
density = 1000
viscosity = "1 mPa s"
[material.cork]
density = 500
young = 1e5
[material.stone]
density = 2000
law = "rigid"
[numerics]
overlap = "remove later"
[[body]]
name = "cork"
material = "cork"
sphere = { radius = 0.04 }
place = { move = [0.1, 0.14, 0.17] }
[[body]]
name = "stone"
material = "stone"
box = { size = [0.07, 0.06, 0.05] }
place = { move = [0.2, 0.17, 0.1] }
[[body]]
name = "water"
material = "water"
box = { size = [0.3, 0.3, 0.18] }
place = { bottom = [0.15, 0.15, 0] }
[output]
every = 0.02
SCENE
ALL_RANKS=1 sameOnAllRanks $scene 90 "20 50" "$work/tub.toml"
finish
