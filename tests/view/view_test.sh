#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The page of `thaw view` in headless Chromium: it shows finished and running runs, refuses others, and
# survives damaged frames. PICTURE=FILE makes the picture of the manual instead.
. "$(dirname "$0")/browser.sh"
"$thaw" view "$work/none" >"$work/log" 2>&1
grep -q "is built without" "$work/log" && skip "$(cat "$work/log")"
expectMessage "no such folder" "a missing folder"

servers=()
trap 'kill "${servers[@]}" 2>/dev/null; rm -rf "$work"' EXIT
serve() {  # serve RUN: starts a server; $address is that of the page
  DISPLAY='' WAYLAND_DISPLAY='' "$thaw" view "$1" --port "$((20000 + RANDOM % 30000))" >"$work/served" 2>&1 &
  servers+=($!)
  for _ in $(seq 100); do grep -q http "$work/served" && break; sleep 0.1; done
  address=$(grep -o 'http://[^ ]*' "$work/served" | head -n 1)
  [ -n "$address" ] || { fail "thaw view $1 gives no address"; cat "$work/served"; }
}

if [ -n "${PICTURE:-}" ]; then
  simulate "$scenes/melt.toml" --set 'spacing="6 mm"' --set end=1.5 --out "$work/melt"
  serve "$work/melt"
  inBrowser picture "$(realpath "$PICTURE")"
  finish
  exit
fi

simulate "$scenes/dam_break.toml" --set spacing=0.05 --set end=0.4 --out "$work/dam"
serve "$work/dam"
inBrowser refusals
inBrowser particles
inBrowser picking
inBrowser motion particles
head -c 3000 "$work/dam/frames/dam_break_000016.hdf" >"$work/half"
mv "$work/half" "$work/dam/frames/dam_break_000016.hdf"
inBrowser damaged

simulate "$scenes/melt.toml" --set spacing=0.012 --set end=0.1 --out "$work/melt"
serve "$work/melt"
inBrowser layer surface
inBrowser mesh
inBrowser motion surface
simulate "$scenes/sheet/cloth.toml" --set sheet.cloth.spacing=0.03 --set end=0.1 --out "$work/cloth"
serve "$work/cloth"
inBrowser layer sheet
simulate "$scenes/oriented/weld.toml" --set spacing=0.05 --set end=0.2 --out "$work/weld"
serve "$work/weld"
inBrowser layer oriented

simulate "$scenes/dam_break.toml" --set spacing=0.05 --set end=0.05 --set obstacle.post.look=solid \
  --set 'obstacle.post.colour="#c02010"' --out "$work/solid"
serve "$work/solid"
inBrowser obstacles

# A run with a spacing of 5 cm goes on until the page stops it. Particles leave through a low side meanwhile.
launchInBackground 1 run "$scenes/dam_break.toml" --set spacing=0.05 --set end=1000 --progress 0.5 \
  --set 'domain.sides={x=["wall","open"],y="wall",z=["wall","open"]}' --out "$work/live" \
  >"$work/live.log" 2>&1
for _ in $(seq 100); do [ -f "$work/live/progress.csv" ] && break; sleep 0.1; done
serve "$work/live"
inBrowser live
[ "$failures" -eq 0 ] || killAll -TERM "$work/live"
wait "$launched"; expectExit 75 "the page stops the run"
[ -f "$work/live/checkpoint/a.hdf" ] || fail "a stopped run has a checkpoint"
kill -0 "${servers[@]}" || fail "a server has ended"
finish
