#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Output of `thaw check`: masses with those of the shapes, short advice, ranks, and a range for a surface that
# may splash.
. "$(dirname "$0")/../support/run.sh"
cat >"$work/s.toml" <<'SCENE'
spacing = "2 cm"
end = "0.1 s"
[domain]
min = [-0.5, -0.5, -0.1]
max = [0.5, 0.5, 0.6]
[material.wax]
density = 1000
young = "20 kPa"
viscosity = 1
heat_capacity = 1000
melts = "320 K"
[[body]]
name = "ball"
sphere = { radius = 0.05 }
material = "wax"
[[body]]
name = "brick"
box = { size = [0.1, 0.1, 0.04] }
material = "wax"
place = { move = [0, 0, 0.2] }
[[tempering]]
temperature = 400
over = 0.05
[surface]
SCENE
launch 2 check "$work/s.toml" >"$work/log" 2>&1; expectExit 0 "check"
expectMessage "body 'brick': 50 of wax, 0.4 kg$" "a box of whole spacings"
expectMessage \
  "body 'ball': 81 of wax, 0.648 kg; its shape has 0.52[0-9]* kg: the particles are 23.[0-9] % too heavy" \
  "a coarse ball"
expectMessage '^  more accurate: --set material.wax.hourglass=2 (solids: ' "advice"
expectMessage \
  "^sound speed of liquid 'wax': [0-9.]* m/s, 10 times [0-9.]* m/s, from a fall through [0-9.]* m$" \
  "the sound speed and what sets it"
expectMessage '^  tried on this scene for [0-9]* steps' "advice that was tried"
grep -q 'hydrostatic' "$work/log" && fail "the whole table of settings without --settings"
[ "$(awk 'length > 200' "$work/log" | wc -l)" = 0 ] || fail "lines of more than 200 characters"
expectMessage '^run time: about .* with 2 ranks' "ranks of the call"
expectMessage 'stays together, up to 1[0-9]* if all of it breaks up into drops' "surfels of a splash"
expectMessage ' to .* for the surface)$' "a range of times"
launch 2 check "$work/s.toml" --ranks 5 --settings >"$work/log" 2>&1; expectExit 0 "check --ranks --settings"
expectMessage '^run time: about .* with 5 ranks' "--ranks"
expectMessage '^  liquid at rest (hydrostatic): defaults' "--settings"
sed -i '/melts/d; /tempering/,/over/d' "$work/s.toml"
launch 1 check "$work/s.toml" >"$work/log" 2>&1; expectExit 0 "check of a solid"
grep -q 'breaks up' "$work/log" && fail "a solid that falls apart into drops"
# implausibly large numbers
launch 1 check "$work/s.toml" --set end=1e150 --set output.every=1e149 >"$work/log" 2>&1
expectExit 0 "check of a run without end"
expectMessage '^run time: about more than 1000 years with 1 rank ([0-9.]*e+[0-9]* steps' "a run without end"
grep -qE '[0-9]{20}|\<inf\>' "$work/log" &&
  fail "long numbers, or none: $(grep -E '[0-9]{20}|\<inf\>' "$work/log")"
finish
