#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# benchmarks/keiser also prints its table for runs that --seconds stops: a row of the paper and a row of thaw
# per scene.
. "$(dirname "$0")/../support/run.sh"
export THAW_BUILD=$build
bash "$source_dir/benchmarks/keiser/run" --csv "$work/keiser.csv" --out "$work/runs" \
  --seconds 2 --scenes fluid,freezing --set spacing=0.1 --set surface.spacing=0.05 --set output.every=0.05 \
  --set output.width=160 --set output.height=120 >"$work/log" 2>&1 ||
  { fail "exit $?"; tail -n 5 "$work/log"; }
for scene in fluid freezing; do
  [ "$(grep -c "^$scene,paper,\|^$scene,thaw," "$work/keiser.csv")" = 2 ] ||
    fail "$scene: not two rows in the CSV file"
  grep -q "^$scene .*thaw .* s *$" "$work/log" || { fail "$scene: no row in the table"; cat "$work/log"; }
done
finish
