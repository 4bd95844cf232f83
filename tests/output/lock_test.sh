#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# One run per folder: a second start is refused while the first lives, also with --resume and when both start
# at once. A new run takes over the lock of a killed one. Every other end removes the lock: done, stopped,
# blown up, an error in the scene.
. "$(dirname "$0")/../support/run.sh"
scene=$scenes/drop.toml
settings drop
run() { launch 2 run "$scene" "${set[@]}" --out "$work/$1" "${@:2}" >"$work/log" 2>&1; }
begun() {  # begun FOLDER: in the background, with frames for minutes; returns after the first steps
  launchInBackground 2 run "$scene" "${set[@]}" --set end=1000 --progress 0.2 --out "$work/$1" "${@:2}" \
    >"$work/log.$1" 2>&1
  for _ in $(seq 100); do grep -q '^t .*step [1-9]' "$work/log.$1" && return; sleep 0.1; done
  fail "the run in $1 does not begin"
}
free() { [ ! -e "$work/$1/lock" ] || fail "$2: the lock is still there"; }
holder() { "$thaw" info "$work/$1" >"$work/log" 2>&1; expectMessage "^ *in use .*$2" "info, $3"; }

begun live
pid=$(value "$work/live/lock" pid)
[ "$(value "$work/live/lock" ranks)" = 2 ] || fail "the lock does not have the number of ranks"
for options in "" --resume --force; do
  # shellcheck disable=SC2086
  run live $options; expectExit 3 "a second start, $options"
  [ "$(grep -c '^error: ' "$work/log")" = 1 ] || { fail "not one error"; cat "$work/log"; }
  expectMessage "^error: .*another run uses this folder: process $pid on .* (2 ranks, since " \
    "a second start, $options"
done
launch 2 relax "$scenes/oriented/relax_plane.toml" --out "$work/live" >"$work/log" 2>&1
expectExit 3 "thaw relax in the same folder"
[ ! -e "$work/live/previous" ] && [ ! -e "$work/live/summary.refused.json" ] ||
  fail "a second start changes the folder"
holder live "by process $pid on .* (2 ranks" "a live run"
kill -USR1 "$pid"; wait "$launched"; expectExit 75 "stopped"
free live "stopped"

begun live --resume
killAll -9 "$work/live"
[ -e "$work/live/lock" ] || fail "a kill removes the lock"
holder live "which has ended" "a killed run"
run live --resume --steps 1; expectExit 0 "after a kill"
[ "$(grep -c '^note: process .* has ended and left its lock: this run takes over' "$work/log")" = 1 ] || {
  fail "after a kill: no line"
  cat "$work/log"
}
free live "done"

printf '{"host":"elsewhere","pid":1,"began_ticks":1,"ranks":8,"since":"2030-01-02T03:04:05Z"}\n' \
  >"$work/live/lock"
holder live "the next run needs --force" "another host's run"
run live --resume; expectExit 3 "another host's lock"
expectMessage "process 1 on elsewhere (8 ranks, since 2030-01-02T03:04:05Z).*--force takes the folder" \
  "another host's lock"
run live --resume --steps 1 --force; expectExit 0 "--force"
expectMessage "^note: this run takes over .* from process 1 on elsewhere" "--force"
free live "--force"

# two at once: one runs, the other is refused, and the files of the first are whole
for _ in 1 2; do
  rm -rf "$work/race"
  for which in a b; do
    (
      launch 2 run "$scene" "${set[@]}" --set end=0.001 --out "$work/race" >"$work/log.$which" 2>&1
      echo $? >"$work/code.$which"
    ) &
  done
  wait
  codes=$(sort "$work/code.a" "$work/code.b" | tr '\n' ' ')
  # the first may end before the second checks
  [ "$codes" = "0 3 " ] || [ "$codes" = "0 0 " ] || fail "two at once end with $codes"
  [ "$(value "$work/race/summary.json" status)" = done ] || fail "two at once: no summary"
  free race "two at once"
done

run bad --set spacing=0; expectExit 2 "a mistake"; free bad "a mistake"
run bad --restart; expectExit 2 "nothing to restart from"; free bad "nothing to restart from"
run bad --set numerics.fixed_step=0.01 --set numerics.retries=0 --set end=10
expectExit 4 "blown up"
free bad "blown up"
[ -z "$(find "$work" -name 'lock.*')" ] || fail "left: $(find "$work" -name 'lock.*')"
finish
