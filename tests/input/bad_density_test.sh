#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Bad densities of materials.
. "$(dirname "$0")/../support/bad_input.sh"

# wax NAME LINES: the valid scene with a material that melts, and these lines, from line 8 on
melts='melts = [310, 320]\nheat_capacity = 2000'
wax() { scene "$1" 's/^young.*/young = "20 kPa"\n'"$2"'/'; }
key='material\.jelly\.density'

accepts "densities by phase" run \
  "$(wax good_phases "$melts"'\ndensity = { solid = 900, liquid = "780 kg\/m^3" }')" --steps 3
accepts "equal densities of a solid that does not melt" check \
  "$(wax equal 'density = { solid = 900, liquid = 900 }')"
rejects "a density of 0" "zero\.toml:11:[0-9]+: error: .*solid: must be > 0 kg/m\^3, got 0" \
  2 check "$(wax zero "$melts"'\ndensity = { solid = 0, liquid = 780 }')"
rejects "a negative density" "${key}.*: must be > 0 kg/m\^3, got -5" 2 check "$(wax negative 'density = -5')"
rejects "a density of the solid alone" "${key}: expected the densities of both phases" \
  2 run "$(wax one "$melts"'\ndensity = { solid = 900 }')"
rejects "a density of the liquid alone" "${key}: expected the densities of both phases" \
  2 check "$(wax other "$melts"'\ndensity = { liquid = 900 }')"
rejects "an unknown phase" "unknown key 'gas' in ${key}" \
  2 check "$(wax gas "$melts"'\ndensity = { solid = 900, liquid = 780, gas = 1 }')"
rejects "a solid that never melts" "${key}: only a material that melts has two densities" \
  2 check "$(wax dry 'density = { solid = 900, liquid = 780 }')"
rejects "a wrong unit" "${key}.*: expected a density" \
  2 check "$(wax unit "$melts"'\ndensity = { solid = "900 kg", liquid = 780 }')"
rejects "the paper's heat" "${key}: .numerics\.heat = \"paper\". has one density for both phases" \
  2 check "$(wax paper "$melts"'\ndensity = { solid = 900, liquid = 780 }')" --set numerics.heat=paper
rejects "no weight" '"boussinesq". leaves out the weight, so solid and liquid of .jelly. must not differ' \
  2 check "$(wax light "$melts"'\ndensity = { solid = 900, liquid = 780 }\nexpansion = 1e-3')" \
  --set numerics.buoyancy=boussinesq
allCases
