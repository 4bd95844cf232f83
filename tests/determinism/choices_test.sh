#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Non-default choices of [numerics], and defaults with solids and walls: the same bits on 1, 2, 3, 4 and 7
# ranks and over a restart. Covers all solvers, carried density with shifting, free liquid, a ball that falls
# into water, a full periodic box, buoyancy, initial fields, the printed forms and double precision.
. "$(dirname "$0")/../support/run.sh"
# try NAME SCENE STEPS SETTINGS...
try() {
  local name=$1 scene=$2 steps=$3 options=()
  shift 3
  set=()
  [ -f "$scenes/$(basename "$scene")" ] && settings "$(basename "$scene" .toml)"
  for choice in "$@"; do options+=(--set "$choice"); done
  sameOnAllRanks "$name" "$steps" - "$scene" "${set[@]}" "${options[@]}"
  rm -rf "${work:?}/$name".*
}
cat >"$work/vortices.toml" <<'END'
spacing = 0.05
end = 0.2
[domain]
min = [0, 0, 0]
max = [1, 1, 0.5]
sides = { x = "periodic", y = "periodic", z = "periodic" }
gravity = [0, 0, -1]
[material.liquid]
density = 1
viscosity = 0.01
sound_speed = 10
[[body]]
name = "all"
box = { size = [1, 1, 0.5] }
place = { move = [0.5, 0.5, 0.25] }
material = "liquid"
packing = "relaxed"
END
cat >"$work/float.toml" <<'END'
spacing = 0.05
end = 1
[domain]
min = [0, 0, 0]
max = [1, 0.8, 1.2]
sides = { x = "wall", y = "periodic", z = ["wall", "open"] }
[material.cork]
density = 500
young = "100 kPa"
[material.water]
density = 1000
viscosity = 0.001
[[body]]
name = "ball"
sphere = { radius = 0.15 }
place = { move = [0.5, 0.1, 0.7] }
velocity = [0.5, 0.5, -2]
material = "cork"
[[body]]
name = "bath"
box = { size = [1, 0.8, 0.5] }
place = { move = [0.5, 0.4, 0.25] }
material = "water"
END
cat >"$work/fields.toml" <<'END'
spacing = 0.05
end = 0.2
[domain]
min = [0, 0, 0]
max = [1, 1, 1.5]
sides = { x = "periodic" }
[material.wax]
density = 1000
young = "20 kPa"
viscosity = 0.1
conductivity = 100
heat_capacity = 2000
melts = ["310 K", "320 K"]
[[body]]
name = "drop"
sphere = { radius = 0.3 }
place = { move = [0.9, 0.5, 0.5] }
material = "wax"
packing = "relaxed"
spin = [0, 0, 1]
velocity = { x = "sin(2*pi*y)", z = "-0.5 - 0.1*exp(-x^2)" }
velocity_gradient = [[-1, 0, 0], [0, 0.5, 0], [0, 0, 0.5]]
temperature = "315 + 20*(z - 0.5)"
[[emitter]]
disc = { radius = 0.2 }
centre = [0.5, 0.5, 1.3]
material = "wax"
speed = 2
velocity = { x = "-0.5*(y - 0.5)", y = "0.5*(x - 0.5)" }
temperature = "350 + 10*x"
END
cat >"$work/patch.toml" <<'END'
spacing = 0.05
end = 0.4
[domain]
min = [-2, -2, -0.15]
max = [2, 2, 0.15]
gravity = [0, 0, 0]
sides = { z = "periodic" }
[material.water]
density = 1000
[[body]]
name = "patch"
box = { size = [1, 1, 0.3] }
material = "water"
spin = [0, 0, 5]
END
cat >"$work/cavity.toml" <<'END'
spacing = 0.05
end = 1
[domain]
min = [0, 0, 0]
max = [1, 0.3, 1]
sides = { y = "periodic", z = "wall" }
gravity = [0, 0, -10]
[material.air]
density = 1
viscosity = 0.01
conductivity = 0.01
heat_capacity = 1
expansion = 0.01
[[body]]
name = "air"
box = { size = [1, 0.3, 1] }
place = { move = [0.5, 0.15, 0.5] }
material = "air"
temperature = 305
[[obstacle]]
name = "hot"
plane = { point = [0, 0, 0], normal = [1, 0, 0] }
temperature = 310
[[obstacle]]
name = "cold"
plane = { point = [1, 0, 0], normal = [-1, 0, 0] }
temperature = 300
END
n=numerics
try all_solvers "$scenes/melt.toml" 30 $n.pressure_solver=incompressible $n.viscosity_solver=implicit \
  $n.elastic_substeps=8
try carried_density "$scenes/dam_break.toml" 30 $n.density=continuity $n.shifting=0.1
try free_liquid "$work/patch.toml" 60
try float "$work/float.toml" 80
try full_box "$work/vortices.toml" 30
try start_fields "$work/fields.toml" 30
try buoyancy "$work/cavity.toml" 30
try buoyancy_of_liquid_with_weight "$work/cavity.toml" 30 $n.buoyancy=density \
  $n.pressure_solver=incompressible $n.viscosity_solver=implicit
try printed "$scenes/melt.toml" 30 $n.pressure=printed $n.viscosity=laplacian "$n.tension=colour field" \
  $n.conduction=plain
try pairwise_tension "$scenes/melt.toml" 30 $n.tension=pairwise
try reference "$scenes/melt.toml" 30 quality=reference
try preview "$scenes/melt.toml" 30 quality=preview
finish
