#!/usr/bin/env bash
# Every scene with a "# test:" line gives the same bits on 1, 2, 3, 4 and 7 ranks, and when it is killed with
# -9 and resumed on other numbers of ranks.
# Coarse, so that it takes seconds; every module of the scene is on. STEPS, SCENES: fewer or more of them.
. "$(dirname "$0")/../support/run.sh"
steps=${STEPS:-40}
for scene in ${SCENES:-$(testedScenes)}; do
  settings "$scene"
  n=$steps
  grep -q '^\[\[*emitter' "$scenes/$scene.toml" && n=$((7 * steps))  # little is poured at first
  [ "$scene" = freeze ] && n=$((48 * steps))  # bonds form at last: differences showed only then
  ALL_RANKS=1 sameOnAllRanks "$scene" "$n" killed "$scenes/$scene.toml" "${set[@]}"
  rm -rf "${work:?}/$scene".*
done
finish
