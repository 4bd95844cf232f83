#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Bad flow laws of liquids.
. "$(dirname "$0")/../support/bad_input.sh"

# flow NAME LINES: the valid scene with a liquid instead of the jelly, and these lines, from line 8 on
flow() { scene "$1" 's/^young.*/'"$2"'/'; }
yields='flow = { law = "bingham", yield_stress = "50 Pa", viscosity = "2 Pa s" }'
key='material\.jelly\.flow\.'

accepts "the flow that works" run "$(flow good_flow "$yields")" --steps 3
accepts "tables by temperature" check "$(flow tables 'heat_capacity = 1000\nflow = { law = "bingham", '\
'yield_stress = [["300 K", "50 Pa"], ["400 K", 1]], viscosity = [[300, 20], [400, 1]] }')"
rejects "no law" "no_law\.toml:8:[0-9]+: error: ${key}law: required: \"bingham\"" \
  2 run "$(flow no_law 'flow = { yield_stress = 50 }')"
rejects "an unknown law" "${key}law: expected one of .*got \"binghm\"" \
  2 check "$(flow unknown 'flow = { law = "binghm" }')"
rejects "no yield stress" "${key}yield_stress: required by .law = \"bingham\"" \
  2 check "$(flow no_yield 'flow = { law = "bingham", viscosity = 1 }')"
rejects "no viscosity" "${key}viscosity: required by .law = \"power_law\"" \
  2 check "$(flow no_viscosity 'flow = { law = "power_law", exponent = 0.5 }')"
rejects "an exponent of Bingham" "${key}exponent: not used by .law = \"bingham\"" \
  2 check "$(flow bingham_n 'flow = { law = "bingham", yield_stress = 1, viscosity = 1, exponent = 2 }')"
rejects "an exponent of 0" "${key}exponent: must be between 0\.1 and 3, got 0" \
  2 check "$(flow zero_n 'flow = { law = "power_law", viscosity = 1, exponent = 0 }')"
rejects "a yield stress as a viscosity" "${key}yield_stress: expected a pressure .*got \"5 Pa s\"" \
  2 check "$(flow unit 'flow = { law = "bingham", yield_stress = "5 Pa s", viscosity = 1 }')"
rejects "a negative yield stress" "${key}yield_stress: must be >= 0 Pa, got -1" \
  2 check "$(flow negative 'flow = { law = "bingham", yield_stress = -1, viscosity = 1 }')"
rejects "a table that descends" "${key}viscosity: the first quantities of the pairs must ascend" 2 check \
  "$(flow descends 'flow = { law = "bingham", yield_stress = 1, viscosity = [[400, 1], [300, 2]] }')"
rejects "a yield stress of Carreau" "${key}yield_stress: not used by .law = \"carreau\"" 2 check \
  "$(flow carreau 'flow = { law = "carreau", yield_stress = 1, viscosity = 1, exponent = 0.5, '\
'relaxation_time = 1 }')"
rejects "Carreau without its time" "${key}relaxation_time: required by .law = \"carreau\"" \
  2 check "$(flow no_time 'flow = { law = "carreau", viscosity = 1, exponent = 0.5 }')"
rejects "an unknown key" "unknown key 'yield' in material\.jelly\.flow" \
  2 check "$(flow key 'flow = { law = "bingham", yield_stress = 1, viscosity = 1, yield = 1 }')"
rejects "two viscosities" 'material\.jelly\.viscosity: the table .flow. sets the viscosity' \
  2 check "$(flow two "viscosity = 1\n$yields")"
rejects "a solid that never melts" 'material\.jelly\.flow: this material is never liquid' \
  2 check "$(flow solid "young = \"20 kPa\"\n$yields")"
rejects "no table" 'material\.jelly\.flow: expected a table, got "bingham"' \
  2 check "$(flow text 'flow = "bingham"')"
rejects "short explicit steps" '^warning: .*material\.jelly: at rest its viscosity is up to .*implicit' \
  0 check "$(flow thick "$yields")"
allCases
