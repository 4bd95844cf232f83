#!/usr/bin/env bash
# Choices of [numerics] beside the defaults: the same bits on 1, 2, 3, 4 and 7 ranks and over a restart. All solvers at once; carried density
# with shifting; a full periodic box; the printed forms; double precision.
. "$(dirname "$0")/../support/run.sh"
# name, scene, steps, settings
same() {
  local name=$1 scene=$2 steps=$3 options=()
  shift 3
  settings "$(basename "$scene" .toml)" 2>/dev/null || set=()
  [ -f "$scenes/$(basename "$scene")" ] || set=()
  for choice in "$@"; do options+=(--set "$choice"); done
  go() { launch "$1" run "$scene" "${set[@]}" "${options[@]}" --out "$work/$2" "${@:3}" >"$work/log" 2>&1 || { fail "$name, $2: exit $?"; tail -n 5 "$work/log"; }; }
  for ranks in 1 2 3 4 7; do
    go $ranks "$name.$ranks" --steps "$steps"
    [ "$ranks" = 1 ] && continue
    "$thaw" compare "$work/$name.1" "$work/$name.$ranks" >"$work/log" 2>&1 || { fail "$name: 1 and $ranks ranks differ"; head -n 20 "$work/log"; }
  done
  go 3 "$name.parts" --steps $((steps / 3))
  go 2 "$name.parts" --steps "$steps" --restart
  "$thaw" compare "$work/$name.1" "$work/$name.parts" >"$work/log" 2>&1 || { fail "$name: differs after a restart"; head -n 20 "$work/log"; }
  echo "$name: $(value "$work/$name.1/summary.json" particles) particles, $(value "$work/$name.1/summary.json" step) steps"
  rm -rf "${work:?}/$name".*
}
cat >"$work/vortices.toml" <<'END'
spacing = 0.05
end = 0.2
[domain]
min = [0, 0, 0]
max = [1, 1, 0.5]
sides = { x = "periodic", y = "periodic", z = "periodic" }
gravity = [0, 0, -1]
[material.liquid]
density = 1
viscosity = 0.01
sound_speed = 10
[[body]]
name = "all"
box = { size = [1, 1, 0.5] }
place = { move = [0.5, 0.5, 0.25] }
material = "liquid"
packing = "relaxed"
END
n=numerics
same all_solvers "$scenes/melt.toml" 60 $n.pressure_solver=incompressible $n.viscosity_solver=implicit $n.elastic_substeps=8
same carried_density "$scenes/dam_break.toml" 60 $n.density=continuity $n.shifting=0.1
same full_box "$work/vortices.toml" 60
same printed "$scenes/melt.toml" 60 $n.pressure=printed $n.viscosity=laplacian "$n.tension=colour field" $n.conduction=plain
same pairwise_tension "$scenes/melt.toml" 60 $n.tension=pairwise
same reference "$scenes/melt.toml" 60 quality=reference
same preview "$scenes/melt.toml" 60 quality=preview
finish
