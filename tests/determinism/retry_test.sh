#!/usr/bin/env bash
# A run whose fixed step is too long fails, goes back to its last good state and goes on with half the step: with the same bits on 1, 2, 3, 4
# and 7 ranks, and when it is stopped between a good state and the failure and resumed on another number of ranks. No frame is lost or twice.
. "$(dirname "$0")/../support/run.sh"
retried() { [ "$(value "$1/summary.json" retries)" -ge "$2" ] || fail "$3: $(value "$1/summary.json" retries) retries"; }
sameFrames() { sameRuns "$1" "$2" "$3" "frames/$scene.hdf.series"; }  # sameFrames A B WHAT
# scene, end, fixed step (about three times what is stable), retries at least, steps at which it is stopped: each before a failure
try() {
  scene=$1
  local end=$2 step=$3 least=$4
  settings "$scene"
  set+=(--set end="$end" --set output.every=$(echo "$end" | awk '{ print $1 / 10 }') --set numerics.fixed_step="$step")
  for ranks in 1 2 3 4 7; do
    launch $ranks run "$scenes/$scene.toml" "${set[@]}" --out "$work/$scene.$ranks" >"$work/log" 2>&1
    expectExit 0 "$scene on $ranks ranks"
    expectMessage "^warning: failed at step .*; back to step .*, with 1/[0-9]* of the step" "$scene on $ranks ranks"
    retried "$work/$scene.$ranks" "$least" "$scene on $ranks ranks"
    [ "$ranks" = 1 ] && continue
    sameFrames "$work/$scene.1" "$work/$scene.$ranks" "$scene on $ranks ranks"
  done
  [ "$(grep -c '"name"' "$work/$scene.1/frames/$scene.hdf.series")" = 11 ] || fail "$scene: not 11 frames in the series"
  local ranks=3
  for stop in "${@:5}"; do
    launch $ranks run "$scenes/$scene.toml" "${set[@]}" --steps "$stop" --resume --out "$work/$scene.parts" >"$work/log" 2>&1; expectExit 0 "$scene to step $stop"
    [ "$("$thaw" info "$work/$scene.parts" --json | value - step)" = "$stop" ] || fail "$scene: no checkpoint of step $stop"
    ranks=$((6 - ranks - ranks / 3))  # 3, 2, 4
  done
  launch 2 run "$scenes/$scene.toml" "${set[@]}" --restart --out "$work/$scene.parts" >"$work/log" 2>&1; expectExit 0 "$scene, last part"
  retried "$work/$scene.parts" "$least" "$scene in parts"
  sameFrames "$work/$scene.1" "$work/$scene.parts" "$scene, stopped at $* and resumed,"
  [ -z "$(find "$work/$scene.parts/checkpoint" -name 'good_*.hdf' -newer "$work/$scene.parts/summary.json")" ] || fail "$scene: a good state is left behind"
  echo "$scene: $(value "$work/$scene.1/summary.json" retries) retries, $(value "$work/$scene.1/summary.json" step) steps"
}
try beam 0.15 6e-4 2 20 45 215 230
try pour 0.1 4e-3 3 15 40 90
try freeze 0.08 2e-3 3 8 15

# back in the state of the start, the run is the one that had begun with half the step
settings beam
launch 2 run "$scenes/beam.toml" "${set[@]}" --set output.every=0.01 --set end=0.05 --set numerics.fixed_step=6e-4 --steps 90 --out "$work/half" >"$work/log" 2>&1; expectExit 0 "with a retry"
retried "$work/half" 1 "with a retry"
launch 2 run "$scenes/beam.toml" "${set[@]}" --set output.every=0.01 --set end=0.05 --set numerics.fixed_step=3e-4 --steps 90 --out "$work/short" >"$work/log" 2>&1; expectExit 0 "half the step"
[ "$(value "$work/short/summary.json" retries)" = 0 ] || fail "half the step fails as well"
"$thaw" compare --frames "$work/half" "$work/short" >"$work/log" 2>&1  # their counters differ
expectMessage '^frames: [1-9][0-9]* in both, equal' "half the step from the start"

# no good states, no retry
launch 2 run "$scenes/beam.toml" "${set[@]}" --set numerics.fixed_step=6e-4 --set numerics.retry_every=0 --out "$work/none" >"$work/log" 2>&1; expectExit 4 "retry_every 0"
finish
