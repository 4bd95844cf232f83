#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Rows 29 and 30 of docs/validation/stability.md. Row 29: ranks without particles, one particle on four ranks,
# all particles on one rank, a scene that begins empty. No deadlock, no minimum of an empty set, and the bits
# of one rank. Row 30: a ring and a long bar across all ranks stay in one piece, bit by bit, and break into
# the same pieces.
. "$(dirname "$0")/../support/run.sh"

steps=100000
same() {  # same NAME RANKS...: the scene $work/NAME.toml on 1 rank and on these gives the same bits
  local name=$1
  shift
  launch 1 run "$work/$name.toml" --steps "$steps" --out "$work/$name-1" >"$work/log" 2>&1
  expectExit 0 "$name on 1 rank"
  local ranks equal=0
  for ranks in "$@"; do
    launch "$ranks" run "$work/$name.toml" --steps "$steps" --out "$work/$name-$ranks" >"$work/log" 2>&1
    expectExit 0 "$name on $ranks ranks"
    "$thaw" compare "$work/$name-1" "$work/$name-$ranks" >"$work/log" 2>&1 && equal=$((equal + 1)) || {
      fail "$name: 1 and $ranks ranks differ"
      head -n 5 "$work/log"
    }
  done
  echo "measured: $name: $(value "$work/$name-1/summary.json" particles) particles, \
the same bits on 1 and on $equal of $# other numbers of ranks; \
broken bonds $(value "$work/$name-1/summary.json" broken_bonds)"
}

head='spacing = "1 cm"
end = "60 ms"
[domain]
min = [-0.5, -0.5, -0.05]
max = [0.5, 0.5, 0.5]
[output]
every = "20 ms"
[material.water]
viscosity = "0.1 Pa s"
surface_tension = 0.07
sound_speed = "20 m/s"
[material.wax]
young = "100 kPa"
viscosity = 1
sound_speed = "20 m/s"
conductivity = 100
heat_capacity = 1000
melts = [310, 320]
[material.glass]
young = "100 kPa"
break_stretch = 1.03
law = "neo-hookean"
[[obstacle]]
name = "floor"
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
temperature = 400
'
one() {
  printf '%s[[body]]\nbox = { size = [0.01, 0.01, 0.01] }\nmaterial = "%s"\n'\
'place = { move = [0.1, 0.1, 0.02] }\n' "$head" "$1"
}
one water >"$work/row29_one_liquid.toml"
one wax >"$work/row29_one_solid.toml"
# no particles at first, then a few
printf '%s[[emitter]]\nmaterial = "water"\ncentre = [0.2, 0.2, 0.2]\ndisc = { radius = 0.02 }\nspeed = 2\n'\
'start = 0.02\n' "$head" >"$work/row29_none_at_first.toml"
# all particles in one corner, within one or two cells
printf '%s[[body]]\nbox = { size = [0.03, 0.03, 0.03] }\nmaterial = "wax"\n'\
'place = { move = [0.4, 0.4, 0.02] }\n' "$head" >"$work/row29_all_in_a_corner.toml"
# all particles leave
printf '%s[[body]]\nbox = { size = [0.03, 0.03, 0.03] }\nmaterial = "water"\nvelocity = [-20, 0, 0]\n'\
'place = { move = [-0.45, 0, 0.1] }\n' "$head" >"$work/row29_all_leave.toml"
for scene in row29_one_liquid row29_one_solid row29_none_at_first row29_all_in_a_corner; do
  same $scene 2 4
done
same row29_all_leave 4
# one piece over all ranks; the bar is hit hard enough to break
printf '%s[[body]]\ntorus = { radius = 0.2, tube = 0.02 }\nmaterial = "wax"\n'\
'place = { move = [0, 0, 0.03] }\nspin = [0, 0, 5]\n' "$head" >"$work/row30_ring.toml"
printf '%s[[body]]\nbox = { size = [0.8, 0.03, 0.03] }\nmaterial = "glass"\n'\
'place = { move = [0, 0, 0.06] }\nvelocity = [0, 0, -1]\n[[obstacle]]\nname = "edge"\n'\
'box = { size = [0.02, 0.2, 0.04] }\nplace = { move = [0, 0, 0.02] }\n' "$head" >"$work/row30_bar.toml"
same row30_ring 2 7
same row30_bar 2 7
# An impact presses pieces into the floor. Some particles are projected back onto it at the border of two
# ranks, so that copies on other ranks must follow (random scene 410). Also over a restart while pieces leave
# the domain.
cat >"$work/row30_pieces.toml" <<'SCENE'
spacing = 0.163796
end = 2.0977
seed = 410

[domain]
min = [-2.64151, -2.64151, -0.201209]
max = [2.64151, 2.64151, 3.75589]
gravity = [0, 0, -9.81]
ambient = 440.019
sides = { x = "periodic", y = "open", z = ["open", "open"] }

[output]
every = 0.41954
fields = ["velocity", "temperature", "liquid"]

[numerics]
overlap = "error"
kernel = "mcg03"
tension = "colour field"

[material.m0]
density = 502.702
young = 107828
poisson = -0.0431552
law = "corotated"
hourglass = 0.74037
break_stretch = 1.37232
friction = 0.0767767
restitution = 0.246126

[material.m1]
density = 1931.97
young = 2070.67
law = "neo-hookean"
break_stretch = 1.05328
conductivity = 576.521
heat_capacity = 510.972
convection = 300.81

[[body]]
name = "b0"
material = "m1"
sphere = { radius = 0.647287 }
place = { move = [0.00372843, -0.0151413, 0.735774], rotate_x = 1.796, rotate_y = 4.398e-05 }
temperature = 300
velocity = [-2.45641, 5.16141, -2.87485]
packing = "relaxed"

[[body]]
name = "b1"
material = "m0"
box = { size = [1.00425, 0.653698, 0.602907] }
place = { move = [0.0381466, -0.0445826, 2.27148], rotate_x = 0.9272, rotate_y = 2.64 }
temperature = 300
velocity = [-5.6195, 3.85983, -1.99916]

[[obstacle]]
name = "floor"
plane = { point = [0, 0, 0], normal = [0.00031951, 0.00932957, 1] }
friction = 0.875

SCENE
steps=300
same row30_pieces 3 4
[ "$(value "$work/row30_pieces-1/summary.json" wall_projections)" -gt 0 ] ||
  fail "no particle was projected back onto the floor"
launch 3 run "$work/row30_pieces.toml" --steps 281 --out "$work/parts" >"$work/log" 2>&1
expectExit 0 "first part"
launch 2 run "$work/row30_pieces.toml" --steps 300 --restart --out "$work/parts" >"$work/log" 2>&1
expectExit 0 "second part"
"$thaw" compare "$work/row30_pieces-1" "$work/parts" >"$work/log" 2>&1 || {
  fail "row30_pieces: a restart differs"
  head -n 5 "$work/log"
}
[ "$(value "$work/row30_bar-1/summary.json" broken_bonds)" -gt 0 ] || fail "the bar did not break"
finish
