#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The incompressible pressure solver: the same bits and iterations on 1, 2, 3, 4 and 7 ranks and over a
# restart. Scenes: liquid alone, poured liquid, and solids that melt in it.
. "$(dirname "$0")/../support/run.sh"
# try SCENE STEPS
try() {
  settings "$1"
  sameOnAllRanks "$1" "$2" - "$scenes/$1.toml" "${set[@]}" --set numerics.pressure_solver=incompressible
  grep -Eq '"density_iterations": *[1-9]' "$work/$1.1/summary.json" || fail "$1: no iterations"
  for kind in density divergence; do
    [ "$(value "$work/$1.1/summary.json" ${kind}_iterations)" = \
      "$(value "$work/$1.7/summary.json" ${kind}_iterations)" ] ||
      fail "$1: other ${kind} iterations on 7 ranks"
  done
  echo "$1: $(value "$work/$1.1/summary.json" density_iterations) + \
$(value "$work/$1.1/summary.json" divergence_iterations) iterations"
}
try dam_break 120
try pour 200
try melt 60
finish
