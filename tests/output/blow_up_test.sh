#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A simulation that blows up ends with exit code 4 on every rank and one message that names the particle. A
# summary with the failure, and the earlier frames and checkpoint, remain.
. "$(dirname "$0")/../support/run.sh"
for scene in beam drop; do
  settings "$scene"
  out=$work/$scene
  launch 3 run "$scenes/$scene.toml" "${set[@]}" --set output.every=1e-3 --steps 20 --out "$out" \
    >"$work/log" 2>&1
  expectExit 0 "$scene: first steps"
  frames=$(frameSums "$out" "$scene")
  launch 3 run "$scenes/$scene.toml" "${set[@]}" --set output.every=1e-3 --set numerics.fixed_step=0.01 \
    --set numerics.retries=0 --set end=10 --restart --out "$out" >"$work/log" 2>&1
  expectExit 4 "$scene: a step far too long"
  [ "$(grep -c '^error: ' "$work/log")" = 1 ] || { fail "$scene: not one error message"; cat "$work/log"; }
  expectMessage "blew up at step [0-9]*, .* particle [0-9]* of body '.*fixed_step. may be too long" "$scene"
  [ "$(value "$out/summary.json" status)" = failed ] ||
    fail "$scene: the summary says '$(value "$out/summary.json" status)'"
  [ "$(value "$out/summary.json" particles)" -gt 0 ] || fail "$scene: the summary has no particles"
  after=$(frameSums "$out" "$scene")
  frameIsLost "$frames" "$after" && fail "$scene: earlier frames are gone or changed"
  [ "$("$thaw" info "$out" --json | value - step)" = 20 ] || fail "$scene: the checkpoint of step 20 is gone"
done

# A step that is a thousand times too long from the start: retries do not help. The last snapshot becomes a
# checkpoint from which a shorter step continues.
settings beam
out=$work/absurd
launch 3 run "$scenes/beam.toml" "${set[@]}" --set end=0.6 --set output.every=0.6 \
  --set numerics.fixed_step=0.2 --out "$out" >"$work/log" 2>&1
expectExit 4 "a step a thousand times too long"
expectMessage \
  "^error: .*blew up at step [0-9]*, .* particle [0-9]* of body 'beam' at .*elastic .* \
N.*4 retries from step 0 with steps down to 1/16 did not help; the checkpoint holds step 0" "absurd"
[ "$(grep -c '^error: ' "$work/log")" = 1 ] || { fail "absurd: not one error message"; cat "$work/log"; }
[ "$(value "$out/summary.json" status)" = failed ] && [ "$(value "$out/summary.json" retries)" = 4 ] ||
  fail "absurd: the summary does not say failed after 4 retries"
[ "$("$thaw" info "$out" --json | value - step)" = 0 ] || fail "absurd: no checkpoint of the snapshot"
launch 2 run "$scenes/beam.toml" "${set[@]}" --set output.every=0.6 --restart --out "$out" >"$work/log" 2>&1
expectExit 0 "restart with a step of its own"
[ "$(value "$out/summary.json" status)" = done ] ||
  fail "absurd: restarted, the summary says '$(value "$out/summary.json" status)'"

# Oriented particles can fly out of the domain within fewer steps than there are between two checks of the
# ledger.
for integrator in symplectic rk4; do
  oriented=("$scenes/oriented/relax_plane.toml" --set spacing=0.03 --set end=0.2 --set output.every=0.1
    --set oriented.patch.integrator=$integrator)
  launch 3 run "${oriented[@]}" --set numerics.fixed_step=0.02 --set numerics.retries=0 \
    --out "$work/oriented" >"$work/log" 2>&1
  expectExit 4 "oriented, $integrator: a step far too long"
  [ "$(grep -c '^error: ' "$work/log")" = 1 ] || { fail "oriented: not one error message"; cat "$work/log"; }
  expectMessage \
    "blew up at step [0-9]*, .* oriented particle [0-9]* of 'patch' at .*fixed_step. may be too long" \
    "oriented, $integrator"
done
launch 2 run "${oriented[@]}" --set numerics.fixed_step=0.005 --out "$work/oriented" >"$work/log" 2>&1
expectExit 0 "oriented: a retry at half the step helps"
[ "$(value "$work/oriented/summary.json" retries)" -gt 0 ] || fail "oriented: no retry"

# each check of the stability monitor, triggered by a tight limit
watch() {  # watch SCENE KEY=VALUE MESSAGE [END [MORE=VALUE]]
  settings "$1"
  launch 2 run "$scenes/$1.toml" "${set[@]}" --set numerics.retries=1 --set "numerics.$2" ${5:+--set "$5"} \
    --set numerics.retry_every=20 --steps 150 --out "$work/$1.watch" >"$work/log" 2>&1
  expectExit 4 "$1 with $2"
  expectMessage "^error: .*blew up at step [0-9]*, .*$3.*: particle [0-9]* of .*${4:-1 retries from step}" \
    "$1 with $2"
}
watch dam_break watch_speed=1e-3 "a speed of .* m/s exceeds the limit of .* m/s (factor .numerics.watch_speed"
watch dam_break watch_density=1.001 \
  "a density of 1\.00[1-9].* times the rest density exceeds .numerics.watch_density. (1.001)"
watch drop watch_step=0.99 "the time step, limited by .*, fell to" \
  "half the step would be below .* (.numerics.watch_step.)"
watch dam_break watch_energy=1e-9 "unexplained gain of mechanical energy since \(step\|the run began\)" "" \
  numerics.density=summation
finish
