#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A run can be stopped by a signal, a file, or a limit of time or steps. It ends with a checkpoint, exit code
# 75 (0 for --steps) and a summary, and can be continued. A run that cannot be continued gives the reason.
. "$(dirname "$0")/../support/run.sh"
scene=$scenes/drop.toml
settings drop
run() { launch 2 run "$scene" "${set[@]}" --out "$work/$1" "${@:2}" >"$work/log" 2>&1; }
# stopped WHAT: the folder has a checkpoint of the step in the summary, and the status is "stopped"
stopped() {
  [ "$(value "$work/stop/summary.json" status)" = stopped ] ||
    fail "$1: the summary says '$(value "$work/stop/summary.json" status)'"
  local step
  step=$("$thaw" info "$work/stop" --json | value - step)
  [ -n "$step" ] && [ "$step" = "$(value "$work/stop/summary.json" step)" ] ||
    fail "$1: checkpoint of step '$step', summary of another"
}

run steps --steps 7; expectExit 0 "--steps"
[ "$("$thaw" info "$work/steps" --json | value - step)" = 7 ] || fail "--steps 7 has no checkpoint of step 7"

for signal in USR1 USR2 TERM INT; do
  rm -rf "$work/stop"
  launchInBackground 2 run "$scene" "${set[@]}" --set end=1000 --out "$work/stop" >"$work/log" 2>&1
  for _ in $(seq 100); do grep -q '^t ' "$work/log" && break; sleep 0.1; done
  # to one rank: all must stop together
  kill -"$signal" "$(ranksOf "$work/stop" | head -n 1)"
  wait "$launched"; expectExit 75 "SIG$signal"
  stopped "SIG$signal"
done
launchInBackground 2 run "$scene" "${set[@]}" --set end=1000 --restart --out "$work/stop" >"$work/log" 2>&1
for _ in $(seq 100); do grep -q '^t ' "$work/log" && break; sleep 0.1; done
: >"$work/stop/stop"
wait "$launched"; expectExit 75 "stop file"
stopped "stop file"
run stop --set end=1000 --resume --time-limit 1
expectExit 75 "--time-limit, and the earlier stop file is gone"
stopped "--time-limit"
expectMessage "time limit" "--time-limit"

# timeout signals mpirun and its group, so USR1 may come twice
rm -rf "$work/stop"
timeout -s USR1 4 "${mpi[@]}" -n 2 "$thaw" run "$scene" "${set[@]}" --set end=1000 --out "$work/stop" \
  >"$work/log" 2>&1
expectExit 124 "timeout -s USR1"
stopped "timeout -s USR1"

# stopped relaxation of oriented bodies: `thaw relax` keeps its state, a run keeps nothing from before its
# start
launch 2 relax "$scenes/oriented/weld.toml" --out "$work/relax" --time-limit 1 --progress 0.2 \
  >"$work/log" 2>&1
expectExit 75 "relax --time-limit"
expectMessage "^oriented: iteration [1-9][0-9]* of relaxation, largest force" "relax --progress"
expectMessage "stopped before rest" "relax --time-limit"
[ "$("$thaw" info "$work/relax" --json | value - step)" = 0 ] || fail "relax --time-limit has no checkpoint"
launch 2 relax "$scenes/oriented/relax_plane.toml" --set spacing=0.1 --out "$work/relax" \
  --iterations 3 >"$work/log" 2>&1
expectExit 0 "relax --iterations"
expectMessage "^warning: oriented: 3 iterations.*limit of iterations before rest" "relax --iterations"
expectMessage "^done .*relaxation did not reach rest after 3 iterations" "relax --iterations"
relaxed=(--set oriented.left.relax=1000000)
launchInBackground 2 run "$scenes/oriented/weld.toml" "${relaxed[@]}" --progress 0.2 --out "$work/cut" \
  >"$work/log" 2>&1
for _ in $(seq 100); do grep -q '^oriented: iteration' "$work/log" && break; sleep 0.1; done
kill -TERM "$(ranksOf "$work/cut" | tail -n 1)"
wait "$launched"; expectExit 75 "SIGTERM in relaxation"
[ "$(value "$work/cut/summary.json" status)" = stopped ] &&
  [ -z "$(find "$work/cut" -name '*.hdf')" ] ||
  fail "SIGTERM in relaxation: something was written"
launch 2 run "$scenes/oriented/weld.toml" --set oriented.left.relax=1 --steps 1 --resume --out "$work/cut" \
  >"$work/log" 2>&1
expectExit 0 "--resume without a checkpoint"
expectMessage "there is no checkpoint to resume from: the run starts from the beginning" \
  "--resume without a checkpoint"
launch 2 check "$scenes/oriented/weld.toml" "${relaxed[@]}" >"$work/log" 2>&1
expectExit 0 "check of a scene with relaxation"
expectMessage "1000000 iterations at most; this check does not" "check of a scene with relaxation"
expectMessage "oriented body 'left': [0-9]* particles" "check of a scene with relaxation"
launch 2 check "$scenes/sheet/shell.toml" --set numerics.max_step=never >"$work/log" 2>&1
expectMessage "^time step: no limit at the start; each step ends at the next frame, 0.05 s" \
  "check of a scene without limit"

# a finished run continues when the end is later
run done --set end=0.001; expectExit 0 "short run"
[ "$(value "$work/done/summary.json" status)" = done ] || fail "a finished run is not 'done'"
frames=$(frameSums "$work/done" drop)
run done --set end=0.002 --restart; expectExit 0 "later end"
[ "$(value "$work/done/summary.json" time_s)" = 0.002 ] ||
  fail "later end: ends at $(value "$work/done/summary.json" time_s) s"
after=$(frameSums "$work/done" drop)
frameIsLost "$frames" "$after" && fail "later end: earlier frames changed"
run done --set end=0.002 --restart; expectExit 0 "nothing left to do"

# compare --frames detects a missing frame and a changed one
cp -r "$work/done" "$work/copy"
"$thaw" compare --frames "$work/done" "$work/copy" >"$work/log" 2>&1; expectExit 0 "compare --frames, a copy"
last=$(ls "$work/copy/frames"/drop_*.hdf | tail -n 1)
cp "$work/copy/frames/drop_000000.hdf" "$last"
"$thaw" compare --frames "$work/done" "$work/copy" >"$work/log" 2>&1
expectExit 1 "compare --frames, another frame"
rm "$last"
"$thaw" compare --frames "$work/done" "$work/copy" >"$work/log" 2>&1
expectExit 1 "compare --frames, a frame less"
expectMessage "is not in $work/copy" "compare --frames"
for path in "$work/copy/frames"/drop*; do mv "$path" "${path/frames\/drop/frames\/other}"; done
"$thaw" compare --frames "$work/done" "$work/copy" >"$work/log" 2>&1
expectExit 1 "compare --frames, other names"
expectMessage "no name is in both" "compare --frames, other names"
"$thaw" compare --frames "$work/done" "$work/copy/checkpoint" >"$work/log" 2>&1
expectExit 3 "compare --frames, not a run"

# runs that cannot be continued
run nothing --restart
expectExit 2 "--restart without a checkpoint"
expectMessage "needs a checkpoint" "--restart without a checkpoint"
run steps --restart --set spacing=0.002
expectExit 2 "another spacing"
expectMessage "spacing: 0.0008 -> 0.002" "another spacing"
before=$(cksum <"$work/steps/summary.json")
launch 2 run "$scenes/beam.toml" --restart --out "$work/steps" >"$work/log" 2>&1
expectExit 2 "another scene"
expectMessage "cannot continue" "another scene"
launch 2 run "$scenes/beam.toml" --set spacing=0 --out "$work/steps" >"$work/log" 2>&1
expectExit 2 "a mistake in the scene"
[ "$(cksum <"$work/steps/summary.json")" = "$before" ] &&
  [ "$(value "$work/steps/summary.refused.json" status)" = refused ] ||
  fail "what is refused changes the summary of the run that is there"
run steps --restart --resume; expectExit 2 "--restart and --resume"

# damaged checkpoints
run steps --restart --steps 9; expectExit 0 "two checkpoints"
newest=$("$thaw" info "$work/steps" --json | grep -o '"path": "[^"]*checkpoint/[ab].hdf"' | head -n 1 |
  cut -d'"' -f4)
size=$(stat -c %s "$newest")
cp "$newest" "$work/newest"
truncate -s $((size / 2)) "$newest"
run steps --restart --steps 8
expectExit 0 "newest is truncated"
expectMessage "^warning: .*$(basename "$newest")" "newest is truncated"
expectMessage "continues at .* step 7" "newest is truncated"
grep -q "$(basename "$newest")" "$work/steps/summary.json" ||
  fail "a damaged checkpoint is not among the warnings of the summary"
for file in "$work/steps/checkpoint"/?.hdf; do truncate -s 3000 "$file"; done
run steps --restart
expectExit 3 "both are truncated"
expectMessage "no checkpoint can be read" "both are truncated"
[ "$(value "$work/steps/summary.refused.json" status)" = refused ] ||
  fail "both are truncated: summary.refused.json says '$(value "$work/steps/summary.refused.json" status)'"
[ "$(value "$work/steps/summary.json" status)" != failed ] ||
  fail "both are truncated: the summary of the run is lost"
finish
