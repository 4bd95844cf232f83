#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Instructions of a fixed small step, counted by valgrind, which has no noise. A case may take 3 % more than
# instructions.csv has for this compiler and processor type. The test is skipped with a line without an entry
# there or without valgrind.
#
#   instructions_test.sh BUILD [--update]
#
#   --update   writes the figures of this compiler into instructions.csv
build=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
baseline=$here/instructions.csv
skip() { echo "skipped: $*"; exit 77; }
command -v valgrind >/dev/null || skip "valgrind is not installed (apt-get install valgrind)"
[ -x "$build/tests/small_step" ] || { echo "there is no $build/tests/small_step"; exit 1; }
grep -q 'CMAKE_BUILD_TYPE:[A-Z]*=Release' "$build/CMakeCache.txt" || skip "not a release build"
grep -qE 'THAW_SANITIZE:[A-Z]*=.+' "$build/CMakeCache.txt" && skip "a build with sanitizers"
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
version="$(basename "$(readlink -f "$compiler")")-$("$compiler" -dumpfullversion)" arch=$(uname -m)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# count CASE: instructions of the four steps with their callees
count() {
  valgrind --tool=callgrind --callgrind-out-file="$work/out" \
    --toggle-collect='thaw::step(*' "$build/tests/small_step" "$1" >"$work/log" 2>&1 || {
    cat "$work/log"
    exit 1
  }
  grep -q 'avx2' "$work/log" || skip "valgrind emulates no AVX2 here: $(grep particles "$work/log")"
  sed -n 's/^\(summary\|totals\): *//p' "$work/out" | head -1
}

failed=0 known=0
for case in fluid heat carried elastic mixed; do
  now=$(count "$case") || { code=$?; echo "$now"; exit "$code"; }
  [ "${now:-0}" -gt 1000000 ] || {
    echo "$case: callgrind counted '$now' instructions: the steps were not counted"
    exit 1
  }
  if [ "${2:-}" = --update ]; then
    {
      grep -v "^$version,$arch,$case," "$baseline" 2>/dev/null || echo "compiler,processor,case,instructions"
      echo "$version,$arch,$case,$now"
    } >"$work/csv"
    cp "$work/csv" "$baseline"
    echo "$case: $now, written"
    continue
  fi
  was=$(sed -n "s/^$version,$arch,$case,//p" "$baseline")
  if [ -z "$was" ]; then
    echo "$case: $now instructions; $baseline has no figures of $version on $arch \
(instructions_test.sh BUILD --update adds them)"
    continue
  fi
  known=$((known + 1))
  printf '%s: %d instructions, %d on record: %+.2f %%\n' "$case" "$now" "$was" \
    "$(awk "BEGIN { print 100 * ($now / $was - 1) }")"
  awk "BEGIN { exit !($now > 1.03 * $was) }" && { echo "$case takes over 3 % more"; failed=1; }
done
[ "${2:-}" = --update ] && exit 0
[ "$known" -gt 0 ] || skip "no figures of $version on $arch"
exit "$failed"
