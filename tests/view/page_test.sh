#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Pages without a server in headless Chromium, from disk: `thaw export --as html`, `thaw preview --html`.
. "$(dirname "$0")/browser.sh"
simulate "$scenes/dam_break.toml" --set spacing=0.05 --set end=0.4 --out "$work/dam"
"$thaw" export "$work/dam" --as html >"$work/log" 2>&1
grep -q "is built without" "$work/log" && skip "$(cat "$work/log")"
grep -q "17 frames, about .* s" "$work/log" || fail "export says how large: $(cat "$work/log")"
grep -q "left out" "$work/log" && fail "nothing is left out of a small run: $(cat "$work/log")"
address=file://$work/dam/export/dam.html
inBrowser page

"$thaw" export "$work/dam" --as html --size 1kB >"$work/log" 2>&1
expectExit 3 "a budget below the page itself"
expectMessage "too small" "a budget below the page itself"
least=$(sed -n 's/.*choose --size \([0-9.]*\)MB or more.*/\1/p' "$work/log")
"$thaw" export "$work/dam" --as html --size "${least:-0}MB" --out "$work/least.html" >"$work/log" 2>&1
expectExit 0 "the least size that the message names"

# Half of the data fits into a budget between the least size and that of the whole page.
kilobytes=$(awk -v least="${least:-0}" -v whole="$(stat -c %s "$work/dam/export/dam.html")" \
  'BEGIN { printf "%d", (1000 * least + whole / 1000) / 2 }')
"$thaw" export "$work/dam" --as html --size "${kilobytes}kB" --out "$work/small.html" >"$work/log" 2>&1
expectExit 0 "export within $kilobytes kB"
grep -q "left out to stay within $kilobytes kB and " "$work/log" || fail "no report of what is left out"
[ "$(stat -c %s "$work/small.html")" -le "${kilobytes}000" ] || fail "the page is larger than its budget"
address=file://$work/small.html
inBrowser page "left out of this page"
"$thaw" export "$work/dam" --as html --size large >"$work/log" 2>&1
expectExit 2 "a size that is none"
expectMessage "expected a size such as 5MB or 20MB, got large" "a size that is none"
"$thaw" export "$work/dam" --as html --what surface >"$work/log" 2>&1
expectExit 2 "--what with a page"
"$thaw" export "$work/none" --as html >"$work/log" 2>&1
expectExit 3 "a run that is not there"

simulate "$scenes/melt.toml" --set spacing=0.012 --set end=0.1 --out "$work/melt"
"$thaw" export "$work/melt" --as html --out "$work/melt.html" >"$work/log" 2>&1
expectExit 0 "export of a surface"
address=file://$work/melt.html
inBrowser mesh

"$thaw" preview "$scenes/beam.toml" --html "$work/beam.html" >"$work/log" 2>&1
expectExit 0 "preview --html"
address=file://$work/beam.html
inBrowser preview clamps
finish
