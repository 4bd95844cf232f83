#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Bad scenes: values, keys, files, the command line.
. "$(dirname "$0")/../support/bad_input.sh"

accepts "the scene that works" run "$good" --steps 2

# docs/validation/stability.md, row 26: zero or negative time, extreme steps
accepts "end = 0" run "$good" --set end=0
accepts "frames more frequent than steps" run "$good" --set output.every=1e-6 --steps 3
rejects "negative end" 'end: must be >= 0 s, got -1' 2 run "$good" --set end=-1
rejects "negative step" 'fixed_step: must be >= 0 s, got -0\.1' 2 run "$good" --set numerics.fixed_step=-0.1
rejects "huge step" 'fixed_step: must not be longer than the simulated time' 2 check "$good" \
  --set numerics.fixed_step=1e6
rejects "no step" 'max_step: must be > 0' 2 check "$good" --set numerics.max_step=0
rejects "a frame never" 'every: must be > 0 s, got 0' 2 run "$good" --set output.every=0
rejects "endless frames" 'more than ten million frames' 2 run "$good" --set output.every=1e-12
rejects "a run of months" "^warning: the run takes more than a month: check the end \(1e\+10 s\)" \
  0 check "$good" --set end=1e10 --set output.every=1e5

# Row 27: particles outside of the domain
rejects "body outside" \
  "body 'block': 125 of its 125 particles lie outside of the domain, up to 8.54 m beyond its side z = 0.5 m; \
enlarge" 2 run "$good" --set 'body.block.place.move=[0, 0, 9]'
rejects "body round the domain" \
  "body 'block' overlaps its own image across a periodic side: 20 of its particles lie inside the image" \
  2 run "$good" --set 'domain.sides.x=periodic' --set 'body.block.box.size=[1.04, 0.1, 0.02]'
accepts "obstacle across a periodic side" \
  check "$(scene cut 's/^plane = .*/box = { size = [0.4, 0.4, 0.1] }\nplace = { move = [0.4, 0, 0] }/')" \
  --set 'domain.sides.x=periodic'
rejects "obstacle that meets a step at a periodic side" \
  "^warning: .*/tilt.toml:[0-9:]+ obstacle 'floor' spans the periodic axis x, \
but its two ends do not match" \
  0 check "$(scene tilt 's/normal = .*/normal = [0.1, 0, 1] }/')" --set 'domain.sides.x=periodic'
rejects "body over a side that is not periodic" \
  "body 'block': [0-9]+ of its 125 particles lie outside of the domain, \
up to 0.04 m beyond its side x = 0.5 m; enlarge" 2 run "$good" --set 'domain.sides.y=periodic' \
  --set 'body.block.place.move=[0.5, 0, 0.2]'
rejects "body half outside" \
  "body 'block': [0-9]+ of its 125 particles lie outside of the domain, \
up to 0.04 m beyond its side x = 0.5 m and 0.09 m beyond its side y = -0.5 m; enlarge" 2 check "$good" \
  --set 'body.block.place.move=[0.5, -0.55, 0.2]'

# Row 28: values that spread
rejects "NaN" 'nan\.toml:2:11: error: spacing: must be a finite number, got nan' \
  2 run "$(scene nan 's/^spacing.*/spacing = nan/')"
rejects "infinity" 'inf\.toml:[0-9]+:[0-9]+: error: .*finite' 2 run "$(scene inf 's/young.*/young = inf/')"
rejects "text NaN" 'finite' 2 check "$(scene textnan 's/young.*/young = "nan Pa"/')"
rejects "spacing 0" 'spacing: must be > 0 m, got 0' 2 check "$(scene zero 's/^spacing.*/spacing = 0/')"
rejects "negative spacing" 'negative\.toml:2:11: error: spacing: must be > 0 m' \
  2 run "$(scene negative 's/^spacing.*/spacing = "-2 cm"/')"
rejects "Poisson's ratio 1/2" 'poisson: must be > -1 and < 0\.5' \
  2 run "$(scene poisson 's/young.*/&\npoisson = 0.5/')"
rejects "no mass" 'density: must be > 0 kg/m\^3' 2 run "$(scene mass 's/young.*/&\ndensity = 0/')"
rejects "a liquid that yields" \
  "liquid\.toml:8:16: error: material\.jelly\.yield_strain: requires a solid: set .young" \
  2 check "$(scene liquid 's/young.*/yield_strain = 0.1/')"
rejects "below 0 K" 'temperature: must be > 0 K' \
  2 check "$(scene cold 's/^name = "block"/&\ntemperature = "-300 degC"/')"

# Row 29: fewer particles than ranks
accepts "one particle on three ranks" run "$good" --set 'body.block.box.size=[0.02, 0.02, 0.02]' --steps 3

# keys
rejects "unknown key" "keys\.toml:2:1: error: unknown key 'spacng'; did you mean 'spacing'\?" \
  2 run "$(scene keys 's/^spacing/spacng/')"
rejects "unknown override" "^--set spacng=3: error: unknown key 'spacng'; did you mean 'spacing'\?" \
  2 run "$good" --set spacng=3
rejects "override without a value" 'expected key=value' 2 check "$good" --set spacing
rejects "wrong unit" 'spacing: expected a length such as "2 mm", got "2 kg"' 2 check "$good" \
  --set 'spacing=2 kg'
rejects "unknown body in an override" \
  "'body' has no entry with the name or number 'blocks'; did you mean 'block'\?" \
  2 check "$good" --set body.blocks.velocity='[0, 0, 1]'
rejects "other name of an obstacle" \
  'wall\.toml:[0-9]+:[0-9]+: error: wall: unknown table: expected \[\[obstacle\]\]' \
  2 check "$(scene wall 's/^\[\[obstacle\]\]/[[wall]]/')"
rejects "other name of a thermostat" 'error: tempering: unknown table: expected \[\[thermostat\]\]' \
  2 check "$(scene tempering '$a [[tempering]]\ntemperature = 300')"
rejects "no such material" "unknown material 'jely'; did you mean 'jelly'\?" \
  2 run "$(scene material 's/material = .*/material = "jely"/')"
rejects "same name twice" "duplicate obstacle name 'floor'; first used in line" \
  2 check "$(scene twice '$a [[obstacle]]\nname = "floor"\nsphere = { radius = 0.01 }')"
rejects "nothing to do" 'there is nothing to simulate' 2 run "$(scene nothing '/\[\[body/,/^place/d')"

# likely causes of parser errors
rejects "a quote forgotten" \
  'quote\.toml:2:[0-9]+: error: while parsing .*; the closing quote is missing on this line' \
  2 run "$(scene quote 's/^spacing.*/spacing = "2 cm/')"
rejects "a unit without quotes" 'unit\.toml:2:[0-9]+: error: .*; a quantity with a unit is a text: "2 cm"' \
  2 run "$(scene unit 's/^spacing.*/spacing = 2 cm/')"
rejects "single brackets" 'single\.toml:[0-9]+:1: error: .*; a table of a list is written \[\[body\]\]' \
  2 check "$(scene single '$a [body]\nname = "other"')"

# allowed, with a warning
rejects "a material of nothing" \
  "^warning: --set material\.jely\.young=2e5: material 'jely' is used by no body and no emitter; \
did you mean 'jelly'\?" 0 check "$good" --set 'material.jely.young=2e5'
rejects "degrees without their unit" \
  "^warning: .*body 'block': its temperature is 30 K; a temperature without a unit is in kelvin" \
  0 check "$good" --set body.block.temperature=30

rejects "frames longer than the run" \
  '^warning: .*good.toml: .output.every. \(0.04 s\) exceeds .end. \(0.02 s\): the only frame is the first' \
  0 check "$good"

# buoyancy
liquid=$(scene liquid 's/^young.*/expansion = 2e-4/')
boussinesq="numerics.buoyancy=boussinesq"
accepts "a table of densities" check "$good" --set material.jelly.young=0 \
  --set 'material.jelly.density=[["0 degC", "999.8 kg/m^3"], ["4 degC", "1 g/cm^3"]]'
rejects "expansion of a solid" 'material\.jelly\.expansion: only liquids have buoyancy' 2 check "$good" \
  --set material.jelly.expansion=2e-4
rejects "huge expansion" 'expansion: must be between -0\.1 and 0\.1 1/K, got 2' 2 check "$good" \
  --set material.jelly.expansion=2
rejects "expansion without its unit" 'expansion: expected an expansion such as "2e-4 1/K", got "2e-4 K"' \
  2 check "$liquid" --set 'material.jelly.expansion=2e-4 K'
rejects "expansion twice" 'expansion: the table of densities gives the expansion: remove one' 2 check \
  "$liquid" --set 'material.jelly.density=[[280, 1000], [300, 990]]'
rejects "table that descends" 'density: .*ascend' 2 check "$good" --set material.jelly.young=0 \
  --set 'material.jelly.density=[[300, 990], [280, 1000]]'
rejects "reference of nothing" 'expansion_from: applies only to a liquid with .expansion. or a table' \
  2 check "$good" --set material.jelly.expansion_from=300
rejects "buoyancy of nothing" 'needs a body or emitter of a material with .expansion. or a table' \
  2 check "$good" --set "$boussinesq"
rejects "buoyancy without gravity" 'needs gravity: set .domain.gravity' 2 check "$liquid" \
  --set "$boussinesq" --set 'domain.gravity=[0, 0, 0]'
oil='[material.oil]\ndensity = 900\n[[body]]\nname = "b"\nbox = {}\nmaterial = "oil"'
rejects "buoyancy of two densities" \
  "leaves out the weight, so all materials need one density: 'oil' has 900 kg/m\^3, 'jelly' 1000 kg/m" \
  2 check "$(scene oil "s/^young.*/expansion = 2e-4/;\$a $oil")" --set "$boussinesq"
rejects "weightless liquid" '^warning: .*/liquid.toml: `numerics.buoyancy = "boussinesq"` leaves out' \
  0 check "$liquid" --set "$boussinesq"

# files
rejects "no such scene" 'missing\.toml: error: no such file' 2 run "$work/missing.toml"
rejects "a folder" 'a folder, not a file' 2 check "$work"
: >"$work/empty.toml"
rejects "empty file" 'empty\.toml: error: the file is empty' 2 run "$work/empty.toml"
head -c 190 "$good" >"$work/cut.toml"
rejects "cut file" 'cut\.toml:.*error:' 2 run "$work/cut.toml"
head -c 3000 "$thaw" >"$work/binary.toml"
rejects "a binary" 'binary\.toml.*error:' 2 check "$work/binary.toml"
{ printf '# '; head -c 20000 /dev/zero | tr '\0' 'x'; } >"$work/long.toml"
rejects "a line without end" 'is longer than 16384 characters' 2 run "$work/long.toml"
truncate -s 200M "$work/huge.toml"
rejects "huge file" 'huge\.toml: error: larger than 16 MiB' 2 run "$work/huge.toml"
printf 'include = "loop.toml"\n' >"$work/loop.toml"
rejects "include loop" 'includes itself' 2 run "$work/loop.toml"
printf 'include = "nowhere.toml"\n' >"$work/lost.toml"
rejects "missing include" "nowhere\.toml': no such file" 2 run "$work/lost.toml"

# the command line
rejects "no such option" 'thaw: error: --frobnicate: unknown option of `thaw run`$' 2 run "$good" \
  --frobnicate
rejects "similar option" "error: --step: unknown option of \`thaw run\`; did you mean '--steps'\?" 2 run \
  "$good" --step 5
rejects "similar command" \
  "error: rum: unknown command; expected one of new, run, .*; did you mean 'run'\?" 2 rum "$good"
rejects "arguments without an option" 'error: b.toml c.toml: not expected' 2 check "$good" b.toml c.toml
# a second setting needs its own --set
rejects "a setting without --set" "end=1: each key=value needs its own --set: --set 'end=1'" 2 run "$good" \
  --set spacing=0.02 end=1
rejects "negative steps" '--steps' 2 run "$good" --steps -1
rejects "ranks as an option" 'ranks are started by mpirun: mpirun -n 4 thaw run SCENE' 2 run "$good" --ranks 4
rejects "restart of nothing" '--restart needs a checkpoint.*: leave out --restart, or use --resume' \
  2 run "$good" --restart
allCases
