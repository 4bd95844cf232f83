#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every benchmark of whole steps, output, scaling, sheets, surfaces and time runs to its end at a tiny size
# and writes the rows that its charts read.
#   benchmarks_test.sh BUILD
set -eu
build=$1/benchmarks
export THAW_BUILD=$1
here=$(cd "$(dirname "$0")/../../benchmarks" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

# rows NAME FILE LEAST: the file has its head and at least LEAST rows of the same number of columns, without
# nan or inf
rows() {
  awk -F, -v least="$3" '{ gsub(/"[^"]*"/, "text") }
    NR == 1 { n = NF }
    NF != n || tolower($0) ~ /(^|,)-?(nan|inf)(,|$)/ { bad = 1 }
    END { exit !(NR > least && !bad) }' "$2" ||
    { echo "$1: not $3 good rows in its table:"; cat "$2"; failed=1; }
}
# does NAME COMMAND...: the command exits with 0
does() {
  local name=$1
  shift
  "$@" >"$work/log" 2>&1 || { echo "$name ended with $?:"; tail -20 "$work/log"; failed=1; }
}

for ranks in 1 2; do
  does step mpirun -n $ranks "$build/step" --cases fluid,heat,elastic,mixed,mesh --sizes 1000 \
    --repeat 1 --seconds 0.01 --csv "$work/step.csv"
  rows step "$work/step.csv" 5
  does output mpirun -n $ranks "$build/output" --particles 4000 --repeat 1 --folder "$work/frames" \
    --csv "$work/output.csv"
  rows output "$work/output.csv" 2
  [ ! -e "$work/frames" ] || { echo "output leaves its folder behind"; failed=1; }
done
for case in fluid corner; do
  {
    mpirun -n 1 "$build/scaling" --head
    mpirun -n 2 "$build/scaling" --case $case --particles 4000 --steps 4 --warm 2
  } >"$work/scaling.csv" 2>"$work/log" || {
    echo "scaling --case $case:"
    tail "$work/log"
    failed=1
  }
  rows "scaling --case $case" "$work/scaling.csv" 1
done
does time_to_solution mpirun -n 2 "$build/time_to_solution" --only beam --end 0.0005 --csv "$work/time.csv"
rows time_to_solution "$work/time.csv" 3
does surface "$build/surface" --surfels 2000 --repeat 1 --only iterations --csv "$work/surface.csv"
rows surface "$work/surface.csv" 1
if /usr/bin/python3 -c 'import matplotlib' 2>/dev/null; then  # matplotlib is optional for tests
  does "chart of surfaces" /usr/bin/python3 "$here/surface_chart.py" "$work/surface.csv" "$work/surface.png"
fi
does sheet "$build/sheet" --only accuracy --csv "$work/sheet.csv"
rows sheet "$work/sheet.csv" 3
does sleep python3 "$here/sleep/gain.py" --across 5 --steps 2 --repeats 1 --csv "$work/sleep.csv"
rows sleep "$work/sleep.csv" 3
exit $failed
