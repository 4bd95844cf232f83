#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# `thaw plot` draws finished, running and failed runs, and reports what is missing. `thaw render --latest`
# draws only the newest frame. In a terminal, progress is one line.
. "$(dirname "$0")/../support/run.sh"
settings melt
launch 2 run "$scenes/melt.toml" "${set[@]}" --set end=0.2 --progress 0.1 --out "$work/melt" >"$work/log" 2>&1
expectExit 0 "melt"

"$thaw" render "$work/melt" --latest --width 160 --height 120 >"$work/log" 2>&1
expectExit 0 "render --latest"
[ "$(ls "$work/melt/pictures")" = melt_surface_000004.png ] ||
  fail "render --latest: $(ls "$work/melt/pictures")"
"$thaw" render "$work/melt" --latest --movie >"$work/log" 2>&1; expectExit 2 "a film of one picture"

if script -qec true /dev/null >"$work/log" 2>&1 </dev/null; then
  TERM=xterm script -qec "stty cols 60; '$thaw' run '$scenes/dam_break.toml' --set spacing=0.05 \
    --set end=0.1 --progress 0 --out '$work/terminal'" /dev/null >"$work/terminal.log" 2>&1
  redrawn=$'\r\\[=*>* *\\]  *left .*\033\\[K\r'
  grep -q "$redrawn" "$work/terminal.log" || fail "no line that is redrawn"
  grep -q '^t 0' "$work/terminal.log" && fail "lines of progress scroll in a terminal"
  grep -aq '^done at' <(tr '\r' '\n' <"$work/terminal.log" | sed 's/\x1b\[K//g') || fail "the end of the run"
  long=$(tr '\r' '\n' <"$work/terminal.log" | sed 's/\x1b\[K//g' | grep '^\[' |
    awk '{ if (length > most) most = length } END { print most + 0 }')
  [ "$long" -gt 40 ] && [ "$long" -lt 60 ] || fail "a line of $long characters in 60 columns"
else
  echo "progress in a terminal is not tested: $(cat "$work/log")"
fi
"$thaw" run "$scenes/dam_break.toml" --set spacing=0.05 --set end=0.1 --progress 0 --out "$work/file" \
  >"$work/log" 2>&1
grep -q '^t 0' "$work/log" || fail "no plain lines in a file"

THAW_PYTHON=/bin/false "$thaw" plot "$work/melt" >"$work/log" 2>&1; expectExit 3 "without matplotlib"
expectMessage 'python3-matplotlib' "the missing package"
"$thaw" plot "$work/nothing" >"$work/log" 2>&1; expectExit 3 "a missing folder"
expectMessage 'no such folder' "the missing folder"
if [ "$failures" -eq 0 ] && ! /usr/bin/python3 -c 'import matplotlib, numpy' 2>/dev/null; then
  echo "the rest is skipped: python3-matplotlib is not installed"
  exit 77
fi
export THAW_PYTHON=/usr/bin/python3
"$thaw" plot "$work/melt" >"$work/log" 2>&1; expectExit 0 "plot"
expectMessage "^$work/melt/pictures/plot.png$" "the picture's name"
"$thaw" plot "$work/file" --out "$work/new/dam.png" >"$work/log" 2>&1; expectExit 0 "plot --out"
/usr/bin/python3 - "$work/melt/pictures/plot.png" "$work/new/dam.png" <<'PYTHON' || fail "the pictures"
import sys
import matplotlib.image
for name in sys.argv[1:]:
    picture = matplotlib.image.imread(name)
    inked = (picture[..., :3].min(axis=2) < 0.9).mean()
    assert picture.shape[1] > 1000 and picture.shape[0] > 500 and 0.01 < inked < 0.6, name
PYTHON
# a run that has just begun, a half-written row, and a folder that is not a run
mkdir -p "$work/begun" "$work/none"
head -n 3 "$work/melt/ledger.csv" >"$work/begun/ledger.csv"
printf '17,0.3' >>"$work/begun/ledger.csv"
"$thaw" plot "$work/begun" >"$work/log" 2>&1; expectExit 0 "plot of a run that has begun"
"$thaw" plot "$work/none" >"$work/log" 2>&1; expectExit 3 "plot of a folder that is not a run"
expectMessage 'is not the folder of a started run' "what it is not"
[ -e "$work/none/pictures/plot.png" ] && fail "a picture of nothing"
finish
