#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Lava with the implicit viscosity solver: the same bits on 1, 2, 3, 4 and 7 ranks and over a restart. The
# solver iterates.
. "$(dirname "$0")/../support/run.sh"
settings lava
set+=(--set numerics.viscosity_solver=implicit)
sameOnAllRanks lava 230 "120 180" "$scenes/lava.toml" "${set[@]}"
grep -Eq '"viscous_iterations": *[1-9][0-9][0-9]' "$work/lava.1/summary.json" ||
  fail "the solver made fewer than 100 iterations"
launch 2 run "$scenes/lava.toml" "${set[@]}" --steps 5 --out "$work/line" >"$work/log" 2>&1
expectExit 0 "a few steps"
expectMessage '  viscosity [0-9][0-9]* it$' "progress"
finish
