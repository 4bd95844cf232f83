#!/usr/bin/env bash
# A run that is killed with -9 and resumed on other numbers of ranks ends with the bits of a run that was left alone; frames stay.
. "$(dirname "$0")/../support/run.sh"
for scene in melt freeze; do
  settings=$(sed -n 's/^# test: //p' "$scenes/$scene.toml")
  # shellcheck disable=SC2086
  launch 2 run "$scenes/$scene.toml" $settings --steps 120 --out "$work/whole" >"$work/log" 2>&1 || { fail "$scene: exit $?"; tail -n 5 "$work/log"; continue; }
  # shellcheck disable=SC2086
  launch 3 run "$scenes/$scene.toml" $settings --steps 50 --out "$work/parts" >"$work/log" 2>&1 || fail "$scene, first part: exit $?"
  # shellcheck disable=SC2086
  (launch 2 run "$scenes/$scene.toml" $settings --steps 100000 --resume --set output.checkpoint=0.2 --out "$work/parts" >"$work/log" 2>&1) &
  sleep 2
  pkill -9 -f "out $work/parts" 2>/dev/null
  wait 2>/dev/null
  done_steps=$("$thaw" info "$work/parts" --json | sed -n 's/.*"step": *\([0-9]*\).*/\1/p' | head -n 1)
  if [ "${done_steps:-0}" -lt 120 ]; then
    # shellcheck disable=SC2086
    launch 4 run "$scenes/$scene.toml" $settings --steps 120 --resume --out "$work/parts" >"$work/log" 2>&1 || { fail "$scene, resumed: exit $?"; tail -n 5 "$work/log"; }
    "$thaw" compare "$work/whole" "$work/parts" >"$work/log" 2>&1 || { fail "$scene: killed and resumed run differs"; cat "$work/log"; }
  else
    # it went beyond: compare with a run of that many steps that was left alone
    # shellcheck disable=SC2086
    launch 1 run "$scenes/$scene.toml" $settings --steps "$done_steps" --out "$work/longer" >"$work/log" 2>&1 || fail "$scene: exit $?"
    "$thaw" compare "$work/longer" "$work/parts" >"$work/log" 2>&1 || { fail "$scene: killed run's checkpoint differs"; cat "$work/log"; }
  fi
  rm -rf "${work:?}"/whole "$work"/parts "$work"/longer
done
finish
