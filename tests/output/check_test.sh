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
[[thermostat]]
temperature = 400
over = 0.05
[surface]
SCENE
launch 2 check "$work/s.toml" >"$work/log" 2>&1; expectExit 0 "check"
expectMessage "body 'brick': 50 particles of wax, 0.4 kg$" "a box of whole spacings"
expectMessage \
  "body 'ball': 81 particles of wax, 0.648 kg; its shape has 0.52[0-9]* kg: the particles are 23.[0-9] % too \
heavy" \
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
# A program without its file of settings gives no advice. A damaged file is refused.
mkdir -p "$work/alone/share/thaw"
cp "$thaw" "$work/alone/thaw"
(thaw=$work/alone/thaw && launch 2 check "$work/s.toml" >"$work/log" 2>&1)
expectExit 0 "check without the file"
grep -q 'settings from similar cases' "$work/log" && fail "advice without the file of settings"
sed '3s/,/;/' "$source_dir/docs/accuracy/frontier.csv" >"$work/alone/share/thaw/frontier.csv"
(thaw=$work/alone/thaw && launch 2 check "$work/s.toml" >"$work/log" 2>&1)
expectExit 3 "a damaged file"
expectMessage 'alone/share/thaw/frontier.csv:3: expected the fields case,norm,' "a damaged file"
# --json has all of it, as numbers
launch 2 check "$work/s.toml" --json --set nonsense=1 >"$work/log" 2>"$work/errors"
expectExit 2 "a bad scene"
grep -q "unknown key 'nonsense'" "$work/errors" || fail "the message of --json"
/usr/bin/python3 - "$work/log" <<'PYTHON' || fail "errors as JSON: $(cat "$work/log")"
import json, sys
[error] = json.load(open(sys.argv[1]))['errors']
assert error['file'] == '--set nonsense=1' and 'unknown key' in error['message'] and 'line' not in error
PYTHON
sed 's/^density.*/densty = 1/' "$work/s.toml" >"$work/bad.toml"
launch 1 check "$work/bad.toml" --json >"$work/log" 2>/dev/null; expectExit 2 "a bad key"
/usr/bin/python3 - "$work/log" <<'PYTHON' || fail "errors as JSON: $(cat "$work/log")"
import json, sys
[error] = json.load(open(sys.argv[1]))['errors']
assert (error['line'], error['column']) == (7, 1) and error['file'].endswith('bad.toml'), error
PYTHON
launch 2 check "$work/s.toml" --json >"$work/log" 2>&1; expectExit 0 "check --json"
/usr/bin/python3 - "$work/log" <<'PYTHON' || fail "the report as JSON: $(cat "$work/log")"
import json, sys
report = json.load(open(sys.argv[1]))
ball, brick = report['particles']['bodies']
assert (ball['name'], ball['particles'], ball['material']) == ('ball', 81, 'wax')
assert abs(brick['mass'] - 0.4) < 1e-12 and abs(ball['shape_mass'] - 0.5236) < 1e-3
assert report['errors'] == [] and report['spacing'] == 0.02 and report['estimate']['ranks'] == 2
step, least, most = report['time_step'], *report['estimate']['run_time']
assert 0 < step['start'] < 1 and step['limited_by'] in step['material_limits'] and 0 < least < most
assert step['sound_speeds'][0]['material'] == 'wax' and len(report['modules']) > 3
assert any('hourglass' in line for line in report['settings'])
PYTHON
sed -i '/melts/d; /thermostat/,/over/d' "$work/s.toml"
launch 1 check "$work/s.toml" >"$work/log" 2>&1; expectExit 0 "check of a solid"
grep -q 'breaks up' "$work/log" && fail "a solid that falls apart into drops"
# a setting whose trial is refused, since the domain would be too short for its support
cat >"$work/slab.toml" <<'SCENE'
spacing = "1 cm"
end = "0.2 s"
[domain]
min = [0, 0, 0]
max = ["6 cm", "30 cm", "30 cm"]
gravity = [0, 0, 0]
sides = { x = "periodic" }
[material.water]
density = 1000
surface_tension = "0.05 N/m"
[[body]]
name = "bar"
box = { size = ["6 cm", "10 cm", "10 cm"] }
place = { move = ["3 cm", "15 cm", "15 cm"] }
material = "water"
SCENE
mkdir -p "$work/own/share/thaw"
cp "$thaw" "$work/own/"
printf '%s\n' case,norm,settings,error,time,best 'drop_laplace,pressure jump,,0.04,1,1' \
  'drop_laplace,pressure jump,numerics.support=2.5,0.01,2,1' >"$work/own/share/thaw/frontier.csv"
thaw=$work/own/thaw launch 2 check "$work/slab.toml" >"$work/log" 2>&1; expectExit 0 "check of a slab"
expectMessage '^  left out: *--set numerics.support=2.5 (refused: .*three support radii' "a refused setting"
[ "$(grep -c 'support=2.5' "$work/log")" = 1 ] && ! grep -q 'support=2.5.*support=2.5' "$work/log" ||
  fail "a setting printed twice: $(grep 'support=2.5' "$work/log")"
# implausibly large numbers
launch 1 check "$work/s.toml" --set end=1e150 --set output.every=1e149 >"$work/log" 2>&1
expectExit 0 "check of a run without end"
expectMessage '^run time: about more than 1000 years with 1 rank ([0-9.]*e+[0-9]* steps' "a run without end"
grep -qE '[0-9]{20}|\<inf\>' "$work/log" &&
  fail "long numbers, or none: $(grep -E '[0-9]{20}|\<inf\>' "$work/log")"
# rigid pieces touch after the first steps: a coarse run shows how the cost grows
cat >"$work/rigid.toml" <<'SCENE'
spacing = "2 cm"
end = "1 s"
[domain]
min = [-0.5, -0.5, -0.1]
max = [0.5, 0.5, 0.8]
gravity = [0, 0, -9.81]
[material.stone]
law = "rigid"
density = 2500
[numerics]
max_step = "2 ms"
[[body]]
name = "lower"
box = { size = [0.3, 0.3, 0.2] }
material = "stone"
place = { move = [0, 0, 0.2] }
[[body]]
name = "upper"
box = { size = [0.3, 0.3, 0.2] }
material = "stone"
place = { move = [0, 0, 0.5] }
[[obstacle]]
name = "floor"
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
SCENE
launch 2 check "$work/rigid.toml" >"$work/log" 2>&1; expectExit 0 "check of rigid pieces"
expectMessage 'are included: a run with a spacing of 0.04 m has 1.00 times the steps expected at its start' \
  "growth of the cost"
launch 1 check "$work/rigid.toml" --json >"$work/log" 2>&1; expectExit 0 "check --json of rigid pieces"
/usr/bin/python3 - "$work/log" <<'PYTHON' || fail "growth as JSON: $(cat "$work/log")"
import json, sys
estimate = json.load(open(sys.argv[1]))['estimate']
assert abs(estimate['growth']['steps'] - 1) < 0.01 and estimate['growth']['cost'] > 0
assert abs(estimate['steps'] - 500) < 5
PYTHON
finish
