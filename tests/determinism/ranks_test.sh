#!/usr/bin/env bash
# Every scene gives the same bits on 1, 2, 3, 4 and 7 ranks. Coarse, so that it takes seconds; every module of the scene is on.
. "$(dirname "$0")/../support/run.sh"
steps=${STEPS:-60}
for scene in melt melt_slow freeze pour dam_break beam drop lava; do
  settings=$(sed -n 's/^# test: //p' "$scenes/$scene.toml")
  for ranks in 1 2 3 4 7; do
    # shellcheck disable=SC2086
    launch $ranks run "$scenes/$scene.toml" $settings --steps "$steps" --out "$work/$scene.$ranks" >"$work/log" 2>&1 || { fail "$scene on $ranks ranks: exit $?"; tail -n 5 "$work/log"; continue; }
    [ "$ranks" = 1 ] && continue
    "$thaw" compare "$work/$scene.1" "$work/$scene.$ranks" >"$work/log" 2>&1 || { fail "$scene: 1 and $ranks ranks differ"; cat "$work/log"; }
  done
  rm -rf "${work:?}/$scene".*
done
finish
