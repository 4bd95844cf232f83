#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A run is killed with -9 and resumed on other numbers of ranks. It ends with the bits of an uninterrupted
# run, and no frame is lost or changed. The kill comes at any time, so the reference run may have to continue.
# ranks_test.sh kills all scenes within their steps. STEPS and SCENES select steps and scenes.
. "$(dirname "$0")/../support/run.sh"
steps=${STEPS:-40}
third=$((steps / 3))
for scene in ${SCENES:-melt pour together}; do
  settings "$scene"
  rm -rf "${work:?}"/whole "$work"/parts "$work"/longer
  run() { launch "$1" run "$scenes/$scene.toml" "${set[@]}" --out "$work/$2" "${@:3}" >"$work/log" 2>&1; }
  run 2 whole --steps "$steps" || { fail "$scene: exit $?"; tail -n 5 "$work/log"; continue; }
  run 3 parts --steps "$third" || { fail "$scene, first part: exit $?"; tail -n 5 "$work/log"; continue; }
  before=$(frameSums "$work/parts" "$scene")
  # a checkpoint every 0.2 s of wall-clock time; the kill comes at any moment
  launchInBackground 2 run "$scenes/$scene.toml" "${set[@]}" --set output.checkpoint=0.2 --steps 1000000 \
    --resume --out "$work/parts" >"$work/log" 2>&1
  sleep 1.5
  killAll -9 "$work/parts"
  at=$("$thaw" info "$work/parts" --json 2>"$work/log" | value - step)
  [ -n "$at" ] && [ "$at" -ge "$third" ] || {
    fail "$scene: no checkpoint after the kill (step '$at')"
    cat "$work/log"
    continue
  }
  after=$(frameSums "$work/parts" "$scene")
  frameIsLost "$before" "$after" && fail "$scene: frames from before the kill are gone or changed"
  for frame in "$work/parts/frames"/*.hdf; do
    "$thaw" info "$frame" >/dev/null 2>"$work/log" || {
      fail "$scene: frame cannot be read after the kill"
      cat "$work/log"
    }
  done
  if [ "$at" -lt "$steps" ]; then end=$steps; else end=$((at + 5)); fi
  run 4 parts --steps "$end" --resume || {
    fail "$scene, resumed at step $at: exit $?"
    tail -n 5 "$work/log"
    continue
  }
  whole=whole
  if [ "$end" != "$steps" ]; then  # the reference must reach the same step
    run 1 whole --steps "$end" --resume || {
      fail "$scene, on one rank to step $end: exit $?"
      tail -n 5 "$work/log"
      continue
    }
  fi
  "$thaw" compare "$work/$whole" "$work/parts" >"$work/log" 2>&1 || {
    fail "$scene: killed at step $at and resumed, differs at step $end"
    cat "$work/log"
  }
  echo "$scene: killed at step $at, compared at step $end"
done
finish
