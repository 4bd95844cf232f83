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
# shellcheck source=count_instructions.sh
source "$here/count_instructions.sh"
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
version="$(basename "$(readlink -f "$compiler")")-$("$compiler" -dumpfullversion)" arch=$(uname -m)

failed=0 known=0
for case in fluid heat carried elastic mixed; do
  now=$(count small_step "$case") || { code=$?; echo "$now"; exit "$code"; }
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
