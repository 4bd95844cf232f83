#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Stiff solids in water with substeps (numerics.elastic_substeps): a clamped post that yields, is damped and
# swings over a periodic side. The same bits on 1, 2, 3, 4 and 7 ranks and over a restart, also while bonds
# melt, and with step limits that hold only while there is liquid.
. "$(dirname "$0")/../support/run.sh"
cat >"$work/tank.toml" <<'SCENE'
spacing = "2.5 cm"
end = "60 ms"
[domain]
min = [0, 0, 0]
max = [0.8, 0.3, 0.6]
sides = { x = "wall", y = "periodic", z = ["wall", "open"] }
[numerics]
elastic_substeps = 8
[material.water]
density = 1000
viscosity = "0.02 Pa s"
sound_speed = 20
[material.steel]
density = 3000
young = "50 MPa"
law = "corotated"
damping = "20 1/s"
yield_strain = 0.002
creep_rate = "20 1/s"
[[body]]
name = "column"
box = { size = [0.3, 0.3, 0.3] }
material = "water"
velocity = [3, 0.5, 0]
place = { move = [0.1625, 0.15, 0.1625] }
[[body]]
name = "post"
box = { size = [0.1, 0.1, 0.4] }
material = "steel"
velocity = [0, -1, 0]
place = { move = [0.4, 0.055, 0.2] }
clamp = [{ box = { size = [1, 1, 0.08] }, place = { move = [0.4, 0.1, 0.0] } }]
[output]
every = "20 ms"
SCENE
sameOnAllRanks tank 60 "25 40" "$work/tank.toml"
[ "$(value "$work/tank.1/summary.json" substeps)" -gt 3 ] || fail "the tank has no substeps"
settings melt
sameOnAllRanks melt 24 "12 18" "$scenes/melt.toml" "${set[@]}" --set numerics.elastic_substeps=8
# Covers the fall with four substeps, and melting with surface tension that is evaluated every few steps.
sameOnAllRanks soften 400 "60 250" "$scenes/melt.toml" --set spacing=0.012 --set output.every=0.01 \
  --set body.bust.temperature=312 --set body.bust.place.bottom="[0, 0, 0.008]"
[ "$(value "$work/soften.1/summary.json" liquid_fraction)" != 0 ] || fail "nothing softens"
finish
