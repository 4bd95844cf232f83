#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A title of a thousand characters is whole in summary.json and shortened in printed lines; pictures are
# rendered.
. "$(dirname "$0")/../support/run.sh"
title=$(printf 'a very long title of a scene %.0s' $(seq 35))
{ echo "title = \"$title\"" && jellyBlock; } >"$work/long.toml"
short() {  # checks the output of the last command in $work/log
  grep -q 'a very long title of a scene a very.*\.\.\.$' "$work/log" ||
    fail "$1 does not show the beginning of the title"
  [ "$(awk '{ if (length > most) most = length } END { print most }' "$work/log")" -le 200 ] ||
    fail "$1: a line of more than 200 characters"
}
cd "$work" || exit 1
launch 2 run long.toml --progress 0 >"$work/log" 2>&1; expectExit 0 "run"; short run
[ "$(value out/long/summary.json title)" = "$title" ] || fail "summary.json does not have the whole title"
launch 2 check long.toml >"$work/log" 2>&1; expectExit 0 "check"; short check
"$thaw" info out/long >"$work/log" 2>&1; expectExit 0 "info"; short info
"$thaw" render out/long >"$work/log" 2>&1; expectExit 0 "render"
cmp -s out/long/pictures/long_000000.png out/long/pictures/long_000001.png && fail "no time in the pictures"
launch 2 run long.toml --restart --set end=0.02 >"$work/log" 2>&1; expectExit 0 "restart"; short restart
cd / && finish
