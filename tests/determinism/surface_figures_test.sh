#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The cheap surface cases of the accuracy suite: figures have the same digits on 1, 2, 3 and 4 ranks, and only
# the targets named here are missed.
. "$(dirname "$0")/../support/run.sh"
suite=$build/benchmarks/accuracy
# figures CASE RANKS SETTINGS: the lines of the case without times, into $work/CASE.RANKS
figures() {
  local case=$1 ranks=$2
  shift 2
  timeout 300 "${mpi[@]}" -n "$ranks" "$suite" "$case" "$@" >"$work/log" 2>&1 || {
    fail "$case on $ranks ranks: exit $?"
    tail -n 5 "$work/log"
  }
  grep '^  ' "$work/log" | grep -v 'core-' >"$work/$case.$ranks"
  [ "$(wc -l <"$work/$case.$ranks")" -ge 5 ] || fail "$case on $ranks ranks: too few figures"
}
# try RANKS CASE KNOWN SETTINGS: RANKS is a list; KNOWN is a norm whose target is missed
# (docs/validation/accuracy.md), or "none"
try() {
  local all=$1 case=$2 known=$3 ranks missed
  shift 3
  for ranks in $all; do
    figures "$case" $ranks "$@"
    cmp -s "$work/$case.1" "$work/$case.$ranks" || {
      fail "$case: figures on 1 and $ranks ranks differ"
      diff "$work/$case.1" "$work/$case.$ranks" | head -n 6
    }
  done
  missed=$(grep MISSED "$work/$case.1" | grep -v "^  $known ")
  [ -z "$missed" ] || fail "$case: $missed"
  grep -q '   reached' "$work/$case.1" || fail "$case: no target is reached"
  echo "$case: $(sed -n 1p "$work/$case.1")"
}
[ -x "$suite" ] || fail "there is no $suite"
try "1 3" surface_ball Hausdorff/R --spacing 0.0625
try 1 surface_ball_relaxed none --spacing 0.0625
try "1 3" surface_ball_mesh none --spacing 0.0625
try "1 3" surface_cube none --spacing 0.0625
# 18,000 steps: on one rank only
try 1 surface_spin none --spacing 0.25
finish
