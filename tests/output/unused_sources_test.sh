#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A run warns of each lamp, laser and heated region of which nothing was absorbed since its start: once, at
# its end, with the same text on any number of ranks and after a restart. `thaw check` names empty regions.
. "$(dirname "$0")/../support/run.sh"
cat >"$work/s.toml" <<'SCENE'
spacing = "1 cm"
end = "20 ms"
[domain]
min = [-0.3, -0.3, -0.1]
max = [0.3, 0.3, 0.5]
[numerics]
fixed_step = "1 ms"
[material.wax]
law = "rigid"
density = 900
conductivity = 10
heat_capacity = 2000
[[body]]
name = "block"
box = { size = [0.1, 0.1, 0.1] }
place = { bottom = [0, 0, 0] }
material = "wax"
[[obstacle]]
plane = {}
[output]
every = "10 ms"
[[lamp]]
name = "below the floor"
position = [0, 0, -0.05]
power = 50
[[laser]]
name = "hit"
position = [0, 0, 0.1]
power = 100
radius = "1 cm"
[[laser]]
name = "stray"
position = [0.25, 0, 0.1]
power = 100
radius = "1 cm"
[[laser]]
name = "swept away"
position = [0, 0, 0.1]
power = 100
radius = "1 cm"
motion = [{ time = 0.002 }, { time = 0.006, move = [0.25, 0, 0] }]
[[heated_region]]
name = "full"
power = 100
sphere = { radius = 0.03 }
place = { move = [0, 0, 0.05] }
[[heated_region]]
name = "empty"
power = 100
sphere = { radius = 0.01 }
place = { move = [0.25, 0, 0.4] }
[[heated_region]]
name = "later"
power = 100
sphere = { radius = 0.01 }
place = { move = [0.25, 0, 0.4] }
start = "1 s"
SCENE
place() {  # place NAME: file, line and column of the table of a source
  echo "$work/s.toml:$(($(grep -n -F "name = \"$1\"" "$work/s.toml" | cut -d : -f 1) - 1)):1"
}
unused() {  # unused KIND NAME ENERGY WHY: the warning of a source
  echo "warning: $(place "$2"): $1 '$2' has given $3, and nothing of it was absorbed: $4"
}
light='its light reached no particle of a material with `absorptivity` above 0'
unused lamp "below the floor" "1 J" "$light" >"$work/expected"
unused laser stray "2 J" "$light" >>"$work/expected"
unused "heated region" empty "2 J" "no particle that it heats was in its shape" >>"$work/expected"
warnsAsExpected() {  # warnsAsExpected WHAT: the lines of the last command
  grep 'has given' "$work/log" | diff "$work/expected" - >"$work/difference" ||
    { fail "$1"; cat "$work/difference"; }
}
for ranks in 1 3; do
  launch $ranks run "$work/s.toml" --out "$work/$ranks" >"$work/log" 2>&1; expectExit 0 "$ranks ranks"
  warnsAsExpected "warnings of $ranks ranks"
  [ "$(grep -c 'has given' "$work/$ranks/summary.json")" = 3 ] || fail "the summary of $ranks ranks"
done
# The laser that is swept away hits the block in the first part alone.
launch 2 run "$work/s.toml" --steps 12 --out "$work/parts" >"$work/log" 2>&1; expectExit 0 "first part"
grep -q "'swept away' has given" "$work/log" && fail "a laser that has hit the block"
launch 3 run "$work/s.toml" --resume --out "$work/parts" >"$work/log" 2>&1; expectExit 0 "second part"
warnsAsExpected "warnings after a restart"

launch 2 check "$work/s.toml" >"$work/log" 2>&1; expectExit 0 "check"
expectMessage "$(place empty): heated region 'empty' holds no particle at the start" "an empty region"
[ "$(grep -c 'holds no particle' "$work/log")" = 1 ] || fail "one region is empty while it is on"
finish
