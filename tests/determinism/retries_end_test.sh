#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A failure that occurs with any step: a block falls faster than the stability monitor allows. The run stops
# within the number of retries, however close the snapshots come to the failure. It has the same bits on any
# number of ranks, and when it is stopped between two retries.
. "$(dirname "$0")/../support/run.sh"
cat >"$work/fall.toml" <<'SCENE'
spacing = "2 cm"
end = "1 s"
[domain]
min = [-0.5, -0.5, 0]
max = [0.5, 0.5, 3]
[material.jelly]
young = "20 kPa"
[[body]]
name = "block"
box = { size = [0.1, 0.1, 0.1] }
material = "jelly"
place = { move = [0, 0, 2] }
[numerics]
retry_every = 4
watch_speed = 0.2
[output]
every = "20 ms"
SCENE
run() { launch "$1" run "$work/fall.toml" --out "$work/$2" "${@:3}" >"$work/log" 2>&1; }
message() {
  sed -n 's/^error: the simulation \(blew up at .*numerics.watch_speed.* did not help\);.*/\1/p' "$work/log"
}
ended() {  # ended FOLDER RETRIES WHAT
  [ "$(value "$work/$1/summary.json" retries)" = "$2" ] ||
    fail "$3: $(value "$work/$1/summary.json" retries) retries, not $2"
  expectMessage "$2 retries from step [0-9]* with steps down to 1/$((1 << $2)) did not help" "$3"
}
for retries in 1 3; do
  run 1 one --set numerics.retries=$retries; expectExit 4 "$retries retries"
  ended one $retries "$retries retries"
done
expected=$(message)
[ -n "$expected" ] || { fail "no message"; cat "$work/log"; }
for ranks in 3 7; do
  run $ranks many --set numerics.retries=3; expectExit 4 "$ranks ranks"
  ended many 3 "$ranks ranks"
  [ "$(message)" = "$expected" ] || fail "$ranks ranks: $(message)"
  failed=$(sed -n 's/^warning: failed at step \([0-9]*\),.*/\1/p
    s/^error: .*blew up at step \([0-9]*\),.*/\1/p' "$work/log")
  same "$work/one" "$work/many" "1 and $ranks ranks"
done

# Stop one step before every failure but the first, with retries pending.
[ "$(wc -w <<<"$failed")" = 4 ] && [ "$(sort -nu <<<"$failed")" = "$failed" ] ||
  fail "not four failures, each later: $failed"
runInParts fall "$(awk 'NR > 1 { print $1 - 1 }' <<<"$failed")" "$work/fall.toml" --set numerics.retries=3
mv "$work/fall.parts" "$work/parts"
run 4 parts --set numerics.retries=3 --resume; expectExit 4 "in parts"
ended parts 3 "in parts"
[ "$(message)" = "$expected" ] || fail "in parts: $(message)"
# the last checkpoint is that of the last stop
"$thaw" compare --frames "$work/one" "$work/parts" >"$work/log" 2>&1
expectMessage '^frames: [1-9][0-9]* in both, equal' "whole and in parts"

# retries respect watch_step
run 2 short --set numerics.retries=10 --set numerics.watch_step=0.2; expectExit 4 "watch_step"
ended short 2 "watch_step"
expectMessage 'half the step would be below .* s (`numerics.watch_step`)' "watch_step"
finish
