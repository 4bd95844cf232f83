#!/usr/bin/env bash
# A simulation that blows up ends with exit code 4 on every rank, one message that names the particle, a summary that says so, and the frames
# and the checkpoint of before.
. "$(dirname "$0")/../support/run.sh"
for scene in beam drop; do
  settings "$scene"
  out=$work/$scene
  launch 3 run "$scenes/$scene.toml" "${set[@]}" --set output.every=1e-3 --steps 20 --out "$out" >"$work/log" 2>&1; expectExit 0 "$scene: first steps"
  frames=$(frameSums "$out" "$scene")
  launch 3 run "$scenes/$scene.toml" "${set[@]}" --set output.every=1e-3 --set numerics.fixed_step=0.01 --set end=10 --restart --out "$out" >"$work/log" 2>&1
  expectExit 4 "$scene: a step far too long"
  [ "$(grep -c '^error: ' "$work/log")" = 1 ] || { fail "$scene: not one error message"; cat "$work/log"; }
  expectMessage "blew up at step [0-9]*, .* particle [0-9]* of body '.*fixed_step may be too long" "$scene"
  [ "$(value "$out/summary.json" status)" = failed ] || fail "$scene: the summary says '$(value "$out/summary.json" status)'"
  [ "$(value "$out/summary.json" particles)" -gt 0 ] || fail "$scene: the summary has no particles"
  after=$(frameSums "$out" "$scene")
  [ "${after#"$frames"}" != "$after" ] || fail "$scene: frames of before are gone or changed"
  [ "$("$thaw" info "$out" --json | value - step)" = 20 ] || fail "$scene: the checkpoint of step 20 is gone"
done
finish
