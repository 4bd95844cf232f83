#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Ticks of the page's colour bar are round numbers, and whole for integer fields.
. "$(dirname "$0")/../support/run.sh"
if ! command -v node >/dev/null; then
  echo "skipped: node is not installed"
  exit 77
fi
ticks() {  # ticks MIN MAX LEAST
  node --input-type=module -e '
    const { ticksOf } = await import(process.argv[1]);
    console.log(ticksOf(...process.argv.slice(2).map(Number)).map((v) => v + 0).join(" "));
  ' "$source_dir/viewer/src/panels/colour_bar.js" "$@"
}
[ "$(ticks 0 2 0)" = "0 0.5 1 1.5 2" ] || fail "ticks of numbers: $(ticks 0 2 0)"
[ "$(ticks 0 2 1)" = "0 1 2" ] || fail "ticks of integers: $(ticks 0 2 1)"
[ "$(ticks 12 47 1)" = "20 30 40" ] || fail "ticks of large integers: $(ticks 12 47 1)"
[ "$(ticks 3 3 1)" = "3" ] || fail "ticks of a constant: $(ticks 3 3 1)"
finish
