#!/usr/bin/env bash
# The incompressible pressure solver: the same bits, and the same number of iterations, on 1, 2, 3, 4 and 7 ranks and over a restart; with
# liquid alone, with liquid that is poured, and with solids that melt in it.
. "$(dirname "$0")/../support/run.sh"
solver=(--set numerics.pressure_solver=incompressible)
# name of the scene, steps
same() {
  local scene=$1 steps=$2
  settings "$scene"
  go() { launch "$1" run "$scenes/$scene.toml" "${set[@]}" "${solver[@]}" --out "$work/$2" "${@:3}" >"$work/log" 2>&1 || { fail "$scene, $2: exit $?"; tail -n 5 "$work/log"; }; }
  for ranks in 1 2 3 4 7; do
    go $ranks "$scene.$ranks" --steps "$steps"
    [ "$ranks" = 1 ] && continue
    "$thaw" compare "$work/$scene.1" "$work/$scene.$ranks" >"$work/log" 2>&1 || { fail "$scene: 1 and $ranks ranks differ"; head -n 20 "$work/log"; }
  done
  go 3 "$scene.parts" --steps $((steps / 3))
  go 2 "$scene.parts" --steps "$steps" --restart
  "$thaw" compare "$work/$scene.1" "$work/$scene.parts" >"$work/log" 2>&1 || { fail "$scene: differs after a restart"; head -n 20 "$work/log"; }
  grep -Eq '"density_iterations": *[1-9]' "$work/$scene.1/summary.json" || fail "$scene: no iterations"
  echo "$scene: $(value "$work/$scene.1/summary.json" step) steps, $(value "$work/$scene.1/summary.json" density_iterations) + $(value "$work/$scene.1/summary.json" divergence_iterations) iterations"
}
same dam_break 120
same pour 200
same melt 60
finish
