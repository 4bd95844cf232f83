#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# thaw run --profile: the table, and a trace that is whole however the run ends; neither without --profile.
. "$(dirname "$0")/../support/run.sh"
check() {
  /usr/bin/env python3 "$(dirname "$0")/../support/check_trace.py" "$@" >"$work/log" 2>&1 || {
    fail "trace"
    cat "$work/log"
  }
}
settings melt
for ranks in 1 3; do
  launch $ranks run "$scenes/melt.toml" "${set[@]}" --steps 40 --profile \
    --trace-steps 7 --out "$work/run.$ranks" >"$work/log" 2>&1
  expectExit 0 "on $ranks ranks"
  expectMessage "^profile of 40 steps of .* particles on $ranks rank" "on $ranks ranks"
  for row in search forces elastic "in no phase" "all work" waiting; do
    expectMessage "^  $row .*%" "table on $ranks ranks"
  done
  [ "$ranks" = 1 ] || expectMessage "^  ghosts  *[1-9]" "table of messages"
  [ "$ranks" = 1 ] || expectMessage "collectives per step" "table of messages"
  check "$work/run.$ranks/trace.json" "$ranks" 7 ghosts,refresh,bonds
done
launch 2 run "$scenes/melt.toml" "${set[@]}" --steps 40 --out "$work/plain" >"$work/log" 2>&1
expectExit 0 "without"
grep -q "profile" "$work/log" && fail "a table without --profile"
[ -e "$work/plain/trace.json" ] && fail "a trace without --profile"
"$thaw" compare "$work/plain" "$work/run.3" >"$work/log" 2>&1 || fail "--profile changes the result"
# fewer steps than the trace can hold, stopped early; and a run that blows up
timeout 60 "${mpi[@]}" -n 2 "$thaw" run "$scenes/melt.toml" "${set[@]}" --time-limit 0.3 --profile \
  --trace-steps 10000 --out "$work/cut" >"$work/log" 2>&1
expectExit 75 "stopped by --time-limit"
check "$work/cut/trace.json" 2 "$(value "$work/cut/summary.json" step)" ghosts,refresh,bonds
settings beam
launch 2 run "$scenes/beam.toml" "${set[@]}" --set numerics.fixed_step=5e-3 --set numerics.retries=0 \
  --profile --trace-steps 1 --out "$work/bad" >"$work/log" 2>&1
expectExit 4 "blows up"
check "$work/bad/trace.json" 2 1 bonds
launch 2 run "$scenes/melt.toml" --trace-steps 3 --out "$work/usage" >"$work/log" 2>&1
expectExit 2 "--trace-steps alone"
finish
