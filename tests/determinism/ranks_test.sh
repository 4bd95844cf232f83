#!/usr/bin/env bash
# Every scene with a "# test:" line gives the same bits on 1, 2, 3, 4 and 7 ranks. Coarse, so that it takes seconds; every module of the
# scene is on. STEPS, SCENES: fewer or more of them.
. "$(dirname "$0")/../support/run.sh"
steps=${STEPS:-40}
for scene in ${SCENES:-$(testedScenes)}; do
  settings "$scene"
  n=$steps
  grep -q '^\[\[*emitter' "$scenes/$scene.toml" && n=$((7 * steps))  # little is poured at first
  [ "$scene" = freeze ] && n=$((48 * steps))  # bonds form at last: differences showed only then
  for ranks in 1 2 3 4 7; do
    launch $ranks run "$scenes/$scene.toml" "${set[@]}" --steps "$n" --out "$work/$scene.$ranks" >"$work/log" 2>&1
    code=$?
    [ "$code" -eq 0 ] || { fail "$scene on $ranks ranks: exit $code"; tail -n 5 "$work/log"; continue; }
    [ "$ranks" = 1 ] && continue
    "$thaw" compare "$work/$scene.1" "$work/$scene.$ranks" >"$work/log" 2>&1 || { fail "$scene: 1 and $ranks ranks differ"; cat "$work/log"; }
  done
  echo "$scene: $(value "$work/$scene.1/summary.json" particles) particles, $(value "$work/$scene.1/summary.json" step) steps"
  rm -rf "${work:?}/$scene".*
done
finish
