#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Bad tables of surface tension and contact angles.
. "$(dirname "$0")/../support/bad_input.sh"

# liquid NAME LINES: the valid scene with a liquid instead of the jelly, and these lines, from line 8 on
liquid() { scene "$1" 's/^young.*/'"$2"'/'; }
table='surface_tension = [["20 degC", "72.7 mN\/m"], ["80 degC", "62.7 mN\/m"]]\nheat_capacity = 4200'
key='material\.jelly\.'

accepts "a table" run "$(liquid table "$table")" --steps 3
accepts "a contact angle" run "$(liquid angle 'surface_tension = 0.07\ncontact_angle = "30 deg"')" --steps 3
rejects "a table that descends" "${key}surface_tension: the first quantities of the pairs must ascend" \
  2 check "$(liquid descends 'surface_tension = [[300, 0.07], [290, 0.08]]')"
rejects "a tension of 0 in a table" "${key}surface_tension: must be > 0 N\/m, got 0" \
  2 check "$(liquid zero 'surface_tension = [[300, 0.07], [400, 0]]')"
rejects "a table of energies" "${key}surface_tension: expected .*got \"70 mJ\"" \
  2 check "$(liquid unit 'surface_tension = [[300, "70 mJ"], [400, 0.05]]')"
rejects "a table with cohesion of pairs" \
  "${key}surface_tension: a table by temperature needs .numerics\.tension" \
  2 check "$(liquid pairs "$table")" --set numerics.tension=pairwise
rejects "an angle with cohesion of pairs" "${key}contact_angle: contact angles need .numerics\.tension" \
  2 check "$(liquid angle_pairs 'surface_tension = 0.07\ncontact_angle = 1')" --set numerics.tension=pairwise
water='surface_tension = 0.07\ncontact_angle = 1'
accepts "an angle with curvature" run "$(liquid curvature "$water")" --steps 3 \
  --set numerics.tension=curvature
rejects "curvature with summed densities" 'curvature". needs .numerics\.density = "continuity"' \
  2 check "$(liquid summed "$water")" --set numerics.tension=curvature --set numerics.density=summation
rejects "curvature without shifting" "numerics\.shifting. above 0" \
  2 check "$(liquid unshifted "$water")" --set numerics.tension=curvature --set numerics.shifting=0
rejects "curvature with the incompressible solver" 'curvature". needs the equation of state' \
  2 check "$(liquid solver "$water")" --set numerics.tension=curvature \
  --set numerics.pressure_solver=incompressible
rejects "an angle without tension" "${key}contact_angle: has no effect without .surface_tension" \
  2 check "$(liquid dry 'contact_angle = 1')"
rejects "an angle beyond 180 degrees" "${key}contact_angle: must be between 0 and" \
  2 check "$(liquid large 'surface_tension = 0.07\ncontact_angle = "200 deg"')"
rejects "an angle as a length" "${key}contact_angle: expected an angle" \
  2 check "$(liquid metres 'surface_tension = 0.07\ncontact_angle = "1 m"')"
rejects "a table of a solid" "${key}surface_tension: only liquids have surface tension" \
  2 check "$(liquid solid 'young = "20 kPa"\nsurface_tension = [[300, 0.07], [400, 0.05]]')"
allCases
