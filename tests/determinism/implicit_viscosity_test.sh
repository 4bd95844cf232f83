#!/usr/bin/env bash
# Lava with the implicit viscosity solver: the same bits on 1, 2, 3, 4 and 7 ranks and over a restart; and it had something to do.
. "$(dirname "$0")/../support/run.sh"
settings lava
set+=(--set numerics.viscosity_solver=implicit)
for ranks in 1 2 3 4 7; do
  launch $ranks run "$scenes/lava.toml" "${set[@]}" --steps 230 --out "$work/$ranks" >"$work/log" 2>&1
  expectExit 0 "$ranks ranks"
  [ "$ranks" = 1 ] || "$thaw" compare "$work/1" "$work/$ranks" >"$work/log" 2>&1 || { fail "1 and $ranks ranks differ"; cat "$work/log"; }
done
launch 3 run "$scenes/lava.toml" "${set[@]}" --steps 120 --out "$work/parts" >"$work/log" 2>&1; expectExit 0 "first part"
launch 2 run "$scenes/lava.toml" "${set[@]}" --steps 230 --resume --out "$work/parts" >"$work/log" 2>&1; expectExit 0 "second part"
"$thaw" compare "$work/1" "$work/parts" >"$work/log" 2>&1 || { fail "restart differs"; cat "$work/log"; }
grep -Eq '"viscous_iterations": *[1-9][0-9][0-9]' "$work/1/summary.json" || fail "the solver had nothing to do"
launch 2 run "$scenes/lava.toml" "${set[@]}" --steps 5 --out "$work/line" >"$work/log" 2>&1; expectExit 0 "a few steps"
expectMessage 'viscosity [0-9]* iterations (mean' "progress"
finish
