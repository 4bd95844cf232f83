#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every scene with a "# test:" line gives the same bits on 1, 2, 3, 4 and 7 ranks, and when it is killed with
# -9 and resumed on other numbers of ranks. Scenes are coarse, with every module on. STEPS and SCENES select
# steps and scenes.
. "$(dirname "$0")/../support/run.sh"
steps=${STEPS:-40}
for scene in ${SCENES:-$(testedScenes)}; do
  settings "$scene"
  n=$steps
  grep -q '^\[\[*emitter' "$scenes/$scene.toml" && n=$((7 * steps))  # little is poured at first
  [ "$scene" = freeze ] && n=$((48 * steps))  # bonds form near the end of this scene
  ALL_RANKS=1 sameOnAllRanks "$scene" "$n" killed "$scenes/$scene.toml" "${set[@]}"
  rm -rf "${work:?}/$scene".*
done
finish
