#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Bad lamps, lasers and heated regions.
. "$(dirname "$0")/../support/bad_input.sh"

with() {  # with NAME TEXT: the good scene and a table
  cp "$work/good.toml" "$work/$1.toml"
  printf '%b\n' "$2" >>"$work/$1.toml"
  echo "$work/$1.toml"
}
accepts "a lamp" run "$(with lamp '[[lamp]]\npower = "20 W"\nposition = [0, 0, 0.4]')" --steps 2
accepts "a laser" run "$(with laser '[[laser]]\npower = 20\nradius = 0.01\nposition = [0, 0, 0.4]')" --steps 2
rejects "a lamp without power" 'nopower\.toml:[0-9]+:[0-9]+: error: lamp.*power: is missing' \
  2 check "$(with nopower '[[lamp]]\nposition = [0, 0, 0.4]')"
rejects "a lamp in the dark" 'power: must be > 0 W, got -5' \
  2 check "$(with negative '[[lamp]]\npower = -5\nposition = [0, 0, 0.4]')"
rejects "a power in another unit" 'power: expected a power such as "200 W"' \
  2 check "$(with unit '[[lamp]]\npower = "5 J"\nposition = [0, 0, 0.4]')"
rejects "a sun with power" 'power: has no effect with .kind = "direction".: set .irradiance. instead' \
  2 check "$(with sun '[[lamp]]\nkind = "direction"\npower = 3\nirradiance = 10\ndirection = [0, 0, -1]')"
rejects "a sun without irradiance" 'irradiance: is missing' \
  2 check "$(with pale '[[lamp]]\nkind = "direction"\ndirection = [0, 0, -1]')"
rejects "a bulb with a size" 'width: applies to .kind = "area". only' \
  2 check "$(with wide '[[lamp]]\npower = 3\nposition = [0, 0, 1]\nwidth = 1')"
rejects "no direction" 'direction: must not be zero' \
  2 check "$(with nowhere '[[laser]]\npower = 3\nradius = 1\nposition = [0, 0, 1]\ndirection = [0, 0, 0]')"
rejects "a laser without a radius" 'radius: is missing' \
  2 check "$(with thin '[[laser]]\npower = 3\nposition = [0, 0, 1]')"
rejects "an end before the start" 'end: must not be before .start' \
  2 check "$(with early '[[heated_region]]\npower = 3\nsphere = { radius = 1 }\nstart = 2\nend = 1')"
rejects "keyframes that go back" 'time: keyframes must ascend in time' \
  2 check "$(with back '[[laser]]\npower = 3\nradius = 1\nposition = [0, 0, 1]'\
'\nmotion = [{ time = 1 }, { time = 0 }]')"
rejects "a region of an unknown material" "heated region 'coil': unknown material \
'jely'; did you mean 'jelly'" \
  2 check "$(with unknown '[[heated_region]]\nname = "coil"\npower = 3'\
'\nmaterial = "jely"\nsphere = { radius = 1 }')"
rejects "two lamps of one name" "duplicate lamp name 'a'; first used in line" \
  2 check "$(with twice '[[lamp]]\nname = "a"\npower = 3\nposition = [0, 0, 1]'\
'\n[[lamp]]\nname = "a"\npower = 3\nposition = [0, 0, 1]')"
rejects "a mirror with more than all light" 'absorptivity: must be .*1, got 1\.5' \
  2 check "$(scene bright 's/^young.*/&\nabsorptivity = 1.5/')"
allCases
