# SPDX-License-Identifier: Apache-2.0
# For tests that count instructions with valgrind: sets `work`, a folder, and skips (exit code 77) where
# there is no valgrind or no release build. Needs $build.
skip() { echo "skipped: $*"; exit 77; }
command -v valgrind >/dev/null || skip "valgrind is not installed (apt-get install valgrind)"
grep -q 'CMAKE_BUILD_TYPE:[A-Z]*=Release' "$build/CMakeCache.txt" || skip "not a release build"
grep -qE 'THAW_SANITIZE:[A-Z]*=.+' "$build/CMakeCache.txt" && skip "a build with sanitizers"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# count PROGRAM ARGUMENT...: instructions of the steps of a program in $build/tests with their callees
count() {
  local program=$build/tests/$1 counted
  shift
  [ -x "$program" ] || { echo "there is no $program"; exit 1; }
  valgrind --tool=callgrind --callgrind-out-file="$work/out" --toggle-collect='thaw::step(*' \
    "$program" "$@" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
  grep -q 'avx2' "$work/log" || skip "valgrind emulates no AVX2 here: $(grep particles "$work/log")"
  counted=$(sed -n 's/^\(summary\|totals\): *//p' "$work/out" | head -1)
  [ "${counted:-0}" -gt 1000000 ] || {
    echo "$*: callgrind counted '$counted' instructions: the steps were not counted"
    exit 1
  }
  echo "$counted"
}
