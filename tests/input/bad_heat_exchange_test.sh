#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Bad contact conductances, evaporation and mush of materials.
. "$(dirname "$0")/../support/bad_input.sh"

# with NAME LINES: the valid scene with these lines instead of the material's modulus, from line 8 on
with() { scene "$1" 's/^young.*/'"$2"'/'; }
key='material\.jelly\.'

accepts "a liquid that evaporates" run \
  "$(with good_vapour 'evaporation = 0.1\nevaporation_heat = "2.2 MJ\/kg"')" --steps 3
accepts "a table by temperature" check \
  "$(with table 'evaporation = [["20 degC", 0], [373.15, "1 kg\/(m^2 s)"]]')"
accepts "a mush with contacts" check "$(with good_mush 'young = 1e4\nmelts = [300, 310]\n'\
'heat_capacity = 1000\nconductivity = 1\nmush_drag = 1e6\ncontact_conductance = "500 W\/(m^2 K)"')"
rejects "a negative rate" "negative\.toml:8:[0-9]+: error: ${key}evaporation: must be >= 0" \
  2 run "$(with negative 'evaporation = -1')"
rejects "a rate in another unit" "${key}evaporation: expected a mass flow per area .*got \"1 kg.s\"" \
  2 check "$(with unit 'evaporation = "1 kg\/s"')"
rejects "a table that descends" "${key}evaporation: the first quantities of the pairs must ascend" \
  2 check "$(with descends 'evaporation = [[400, 1], [300, 2]]')"
rejects "a solid that evaporates" "${key}evaporation: only liquids evaporate" \
  2 check "$(with solid 'young = 1e4\nevaporation = 1')"
rejects "a heat without a rate" "${key}evaporation_heat: has no effect without .evaporation" \
  2 check "$(with no_rate 'evaporation_heat = 1e6')"
rejects "no conductance" "${key}contact_conductance: must be > 0" \
  2 check "$(with none 'contact_conductance = 0')"
rejects "contacts that conduct no heat" \
  "idle\.toml:8:[0-9]+: error: ${key}contact_conductance: has no effect without .conductivity" \
  2 check "$(with idle 'contact_conductance = 5')"
rejects "a mush that never melts" "${key}mush_drag: has no effect without .melts" \
  2 check "$(with never_melts 'young = 1e4\nmush_drag = 1e6')"
rejects "a drag in another unit" "${key}mush_drag: expected a drag coefficient" 2 check \
  "$(with drag_unit 'young = 1e4\nmelts = [300, 310]\nheat_capacity = 1\nmush_drag = "3 Pa"')"
rejects "the paper's heat" "${key}contact_conductance: not available with .numerics\.heat = .paper.." \
  2 check "$(with paper 'contact_conductance = 5')" --set 'numerics.heat="paper"'
allCases
