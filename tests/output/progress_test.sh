#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Lines of progress fit on a terminal. progress.csv has the whole ledger, over a kill and on other ranks.
# `thaw info` of the run fits on a screen.
. "$(dirname "$0")/../support/run.sh"
settings melt
scene=$scenes/melt.toml
launch 2 run "$scene" "${set[@]}" --steps 60 --progress 0 --out "$work/run" >"$work/log" 2>&1
expectExit 0 "first part"
[ "$(grep -c '^t ' "$work/log")" -ge 60 ] || fail "fewer than 60 lines of progress"
long=$(grep '^t ' "$work/log" | awk '{ if (length > most) most = length } END { print most }')
[ "$long" -le 170 ] || fail "a line of progress of $long characters"
[ "$(wc -l <"$work/run/progress.csv")" -ge 61 ] || fail "progress.csv does not have a line per step"
launchInBackground 3 run "$scene" "${set[@]}" --resume --progress 0 --set output.checkpoint=0.05 \
  --out "$work/run" >"$work/log" 2>&1
for _ in $(seq 200); do grep -q '^t ' "$work/log" && break; sleep 0.02; done
sleep 0.3
"$thaw" info "$work/run" >"$work/info" || fail "info of a live run"
grep -q '^  status  *running (process [0-9]* on .*; last write at 2.*Z), at t ' "$work/info" ||
  fail "info: a run that runs is '$(grep status "$work/info")'"
# not if summary.json is of the same step
for _ in $(seq 50); do
  grep -q '^  progress  *t .* s, step [0-9]*, dt .* s (limited by .*), .* steps/s$' "$work/info" && break
  "$thaw" info "$work/run" >"$work/info"
done
grep -q '^  progress ' "$work/info" ||
  fail "info does not report the progress of a live run: $(cat "$work/info")"
killAll -9 "$work/run"
"$thaw" info "$work/run" >"$work/info" || fail "info of a killed run"
grep -q '^  status  *killed (process [0-9]* on .* has ended; last write at 2.*Z), last known at t ' \
  "$work/info" || fail "info: a run that was killed is '$(grep status "$work/info")'"
at=$("$thaw" info "$work/run" --json 2>"$work/log" | value - step)
printf '%s' "$((at + 1)),0.1" >>"$work/run/progress.csv"  # a kill in the middle of a line
launch 1 run "$scene" "${set[@]}" --resume --progress 0 --steps $((at + 20)) --out "$work/run" \
  >"$work/log" 2>&1
expectExit 0 "last part"
awk -F, 'NR == 1 { n = NF; next }
  NF != n { print "line " NR ": " NF " fields of " n; bad = 1 }
  NR > 2 && $1 <= last { print "step " $1 " after " last; bad = 1 }
  { last = $1 }
  END { exit bad }' "$work/run/progress.csv" ||
  fail "progress.csv is not whole"
[ "$(tail -n 1 "$work/run/progress.csv" | cut -d, -f1)" = $((at + 20)) ] ||
  fail "progress.csv does not end with the last step"
"$thaw" info "$work/run" >"$work/log" || fail "info"
[ "$(wc -l <"$work/log")" -le 30 ] || fail "info of a run has $(wc -l <"$work/log") lines"
expectMessage "^  status  *done at t .* step $((at + 20))" "info: status"
expectMessage '^  frames .*melt.hdf.series' "info: frames"
expectMessage '^  content  *[0-9]* particles, .* % liquid, [0-9]* surfels' "info: what it holds"
"$thaw" info "$work/run" --all >"$work/log" || fail "info --all"
[ "$(wc -l <"$work/log")" -gt 200 ] || fail "info --all is not complete"
"$thaw" info "$(ls "$work/run"/checkpoint/*.hdf | head -n 1)" >"$work/log" || fail "info of a checkpoint"
[ "$(wc -l <"$work/log")" -le 60 ] || fail "info of a checkpoint has $(wc -l <"$work/log") lines"
grep -q momentum "$work/log" && fail "info of a checkpoint: sums of the ledger without --all"
finish
