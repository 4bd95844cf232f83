#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A liquid with a yield stress that depends on temperature, beside a solid that melts into it, with explicit
# and implicit viscosity. It has the same bits on 1, 2, 3, 4 and 7 ranks and over a restart.
. "$(dirname "$0")/../support/run.sh"
cat >"$work/paste.toml" <<'T'
title   = "Paste that flows over a hot plate"
spacing = "2 cm"
end     = "10 s"

[domain]
min = [-0.3, -0.3, 0]
max = [0.3, 0.3, 0.4]

[output]
every  = 0.05
fields = ["velocity", "viscosity", "temperature", "liquid"]

[material.paste]
density       = 1500
young         = "30 kPa"
law           = "neo-hookean"
melts         = [310, 320]
heat_capacity = 500
conductivity  = 50

[material.paste.flow]
law          = "herschel_bulkley"
yield_stress = [[300, "200 Pa"], [400, "20 Pa"]]
viscosity    = [[300, "20 Pa s"], [400, "5 Pa s"]]
exponent     = 0.6
least_rate   = 1

[[body]]
name        = "melt"
box         = { size = [0.2, 0.2, 0.16] }
place       = { bottom = [-0.1, 0, 0] }
material    = "paste"
temperature = 360

[[body]]
name        = "lump"
box         = { size = [0.12, 0.12, 0.12] }
place       = { bottom = [0.06, 0, 0] }
material    = "paste"
temperature = 305

[[obstacle]]
name        = "plate"
plane       = { point = [0, 0, 0], normal = [0, 0, 1] }
temperature = 400
T
for solver in explicit implicit; do
  set=(--set "numerics.viscosity_solver=$solver")
  sameOnAllRanks "$solver" 150 "80 120" "$work/paste.toml" "${set[@]}"
done
grep -Eq '"viscous_iterations": *[1-9][0-9][0-9]' "$work/implicit.1/summary.json" ||
  fail "the solver made fewer than 100 iterations"
finish
