#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A run whose fixed step is too long fails, returns to its last snapshot and continues with half the step. It
# has the same bits on 1, 2, 3, 4 and 7 ranks. A stop between the snapshot and the failure, resumed on another
# number of ranks, does not change them. No frame is lost or duplicated.
. "$(dirname "$0")/../support/run.sh"
retried() {
  [ "$(value "$1/summary.json" retries)" -ge "$2" ] || fail "$3: $(value "$1/summary.json" retries) retries"
}
same() { sameRuns "$1" "$2" "$3" "frames/$scene.hdf.series"; }
# try SCENE END STEP RETRIES STOPS: STEP is fixed, about three times the stable one; RETRIES is a minimum;
# each stop is before a failure
try() {
  scene=$1
  local end=$2 step=$3 least=$4 run
  settings "$scene"
  set+=(--set end="$end" --set output.every=$(echo "$end" | awk '{ print $1 / 10 }')
    --set numerics.fixed_step="$step")
  sameOnAllRanks "$scene" 1000000 "${*:5}" "$scenes/$scene.toml" "${set[@]}"
  for run in 1 7 parts; do retried "$work/$scene.$run" "$least" "$scene, $run"; done
  for run in 1 7; do
    grep -q "^warning: failed at step .*; back to step .*, with 1/[0-9]* of the step" \
      "$work/$scene.log.$run" || fail "$scene on $run ranks: no warning"
    [ "$(grep "^warning: failed at step" "$work/$scene.log.$run" | sort | uniq -d | wc -l)" = 0 ] ||
      fail "$scene on $run ranks: a warning of a retry twice"
  done
  [ "$(grep -c '"name"' "$work/$scene.1/frames/$scene.hdf.series")" = 11 ] ||
    fail "$scene: not 11 frames in the series"
  [ -z "$(find "$work/$scene.parts/checkpoint" -name 'good_*.hdf' \
    -newer "$work/$scene.parts/summary.json")" ] || fail "$scene: a snapshot file is left behind"
  echo "$scene: $(value "$work/$scene.1/summary.json" retries) retries"
}
try beam 0.15 6e-4 2 20 45 215 230
try pour 0.1 4e-3 3 15 40 90
try freeze 0.08 2e-3 3 8 15

# A run that returns to its start equals one that begins with half the step.
settings beam
launch 2 run "$scenes/beam.toml" "${set[@]}" --set output.every=0.01 --set end=0.05 \
  --set numerics.fixed_step=6e-4 --steps 90 --out "$work/half" >"$work/log" 2>&1
expectExit 0 "with a retry"
retried "$work/half" 1 "with a retry"
launch 2 run "$scenes/beam.toml" "${set[@]}" --set output.every=0.01 --set end=0.05 \
  --set numerics.fixed_step=3e-4 --steps 90 --out "$work/short" >"$work/log" 2>&1
expectExit 0 "half the step"
[ "$(value "$work/short/summary.json" retries)" = 0 ] || fail "half the step fails as well"
"$thaw" compare --frames "$work/half" "$work/short" >"$work/log" 2>&1  # their counters differ
expectMessage '^frames: [1-9][0-9]* in both, equal' "half the step from the start"

# no snapshots, no retry
launch 2 run "$scenes/beam.toml" "${set[@]}" --set numerics.fixed_step=6e-4 --set numerics.retry_every=0 \
  --out "$work/none" >"$work/log" 2>&1
expectExit 4 "retry_every 0"
finish
