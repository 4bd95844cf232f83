#!/usr/bin/env bash
# The incompressible pressure solver: the same bits, and the same number of iterations, on 1, 2, 3, 4 and 7 ranks and over a restart; with
# liquid alone, with liquid that is poured, and with solids that melt in it.
. "$(dirname "$0")/../support/run.sh"
# same SCENE STEPS
same() {
  settings "$1"
  sameOnAllRanks "$1" "$2" $(($2 / 3)) "$scenes/$1.toml" "${set[@]}" --set numerics.pressure_solver=incompressible
  grep -Eq '"density_iterations": *[1-9]' "$work/$1.1/summary.json" || fail "$1: no iterations"
  for ranks in 2 3 4 7; do
    for kind in density divergence; do
      [ "$(value "$work/$1.1/summary.json" ${kind}_iterations)" = "$(value "$work/$1.$ranks/summary.json" ${kind}_iterations)" ] || fail "$1: other ${kind} iterations on $ranks ranks"
    done
  done
  echo "$1: $(value "$work/$1.1/summary.json" density_iterations) + $(value "$work/$1.1/summary.json" divergence_iterations) iterations"
}
same dam_break 120
same pour 200
same melt 60
finish
