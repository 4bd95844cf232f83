#!/usr/bin/env bash
# Bad input on three ranks: the documented exit code, one clear message (once, not once a rank), no crash, no hang.
. "$(dirname "$0")/../support/run.sh"
limit=${LIMIT:-60}  # seconds a case may take

# A small scene that works; every case below breaks it in one place.
cat >"$work/good.toml" <<'SCENE'
title = "a block"
spacing = "2 cm"
end = "20 ms"
[domain]
min = [-0.5, -0.5, -0.1]
max = [0.5, 0.5, 0.5]
[material.jelly]
young = "20 kPa"
[[body]]
name = "block"
box = { size = [0.1, 0.1, 0.1] }
material = "jelly"
place = { move = [0, 0, 0.1] }
[[obstacle]]
name = "floor"
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
SCENE

# Cases run beside each other, each in a folder of its own: most of a call is the start of three processes.
cases=0
started() {  # a further case in the background: started COMMAND ARGUMENTS
  while [ "$(jobs -rp | wc -l)" -ge "${JOBS:-$(nproc)}" ]; do wait -n; done
  cases=$((cases + 1))
  ( place=$work/case.$cases; mkdir "$place"; failures=0; "$@" >"$place/said"; exit "$failures" ) &
  pids+=($!)
}
pids=()
allEnded() {
  local pid i=0
  for pid in "${pids[@]}"; do
    i=$((i + 1))
    wait "$pid" || { failures=$((failures + 1)); cat "$work/case.$i/said"; }
  done
}

# calls thaw on three ranks: call COMMAND SCENE [options]; leaves the code in $code and what was said in $place/log
call() {
  local command=$1 scene=$2
  shift 2
  local out=()
  [ "$command" = run ] && out=(--out "$place/out")
  timeout -k 5 "$limit" mpirun --allow-run-as-root --oversubscribe --bind-to none -n 3 "$thaw" "$command" "$scene" "${out[@]}" "$@" >"$place/log" 2>&1
  code=$?
}

# rejects CASE PATTERN CODE COMMAND SCENE [options]: that code, and the pattern in exactly one line
rejects() { started isRejected "$@"; }
isRejected() {
  local name=$1 pattern=$2 wanted=$3
  shift 3
  call "$@"
  local times
  times=$(grep -a -c -E -- "$pattern" "$place/log")
  if [ "$code" = 124 ] || [ "$code" = 137 ]; then fail "$name: hangs (no end after $limit s)"
  elif [ "$code" != "$wanted" ]; then fail "$name: exit code $code instead of $wanted"; head -n 5 "$place/log"
  elif [ "$times" != 1 ]; then fail "$name: '$pattern' in $times lines instead of 1"; head -n 8 "$place/log"
  elif grep -a -q -E 'terminate called|Segmentation|Signal:|MPI_ABORT' "$place/log"; then fail "$name: crashed"; head -n 8 "$place/log"
  fi
}

# accepts CASE COMMAND SCENE [options]: exit code 0
accepts() { started isAccepted "$@"; }
isAccepted() {
  local name=$1
  shift
  call "$@"
  [ "$code" = 0 ] || { fail "$name: exit code $code"; head -n 8 "$place/log"; }
}

# scene NAME SED-SCRIPT: a copy of the scene that works, edited
scene() { sed -E "$2" "$work/good.toml" >"$work/$1.toml"; echo "$work/$1.toml"; }
good=$work/good.toml

accepts "the scene that works" run "$good" --steps 2

# accuracy.md B26: no time, time that runs backwards, steps beyond all limits
accepts "end = 0" run "$good" --set end=0
accepts "frames more frequent than steps" run "$good" --set output.every=1e-6 --steps 3
rejects "negative end" 'end: must be >= 0 s, got -1' 2 run "$good" --set end=-1
rejects "negative step" 'fixed_step: must be >= 0 s, got -0\.1' 2 run "$good" --set numerics.fixed_step=-0.1
rejects "huge step" 'fixed_step: must not be longer than the simulated time' 2 check "$good" --set numerics.fixed_step=1e6
rejects "no step" 'max_step: must be > 0' 2 check "$good" --set numerics.max_step=0
rejects "a frame never" 'every: must be > 0 s, got 0' 2 run "$good" --set output.every=0
rejects "endless frames" 'more than ten million frames' 2 run "$good" --set output.every=1e-12

# B27: particles outside of the domain
rejects "body outside" "lie outside of the domain.*'block'" 2 run "$good" --set 'body.block.place.move=[0, 0, 9]'
rejects "body round the domain" "body 'block' reaches round the domain into itself: 20 of its particles lie inside its image" 2 run "$good" --set 'domain.sides.x=periodic' --set 'body.block.box.size=[1.04, 0.1, 0.02]'
rejects "body over a side that is not periodic" "lie outside of the domain.*'block'" 2 run "$good" --set 'domain.sides.y=periodic' --set 'body.block.place.move=[0.5, 0, 0.2]'
rejects "body half outside" "lie outside of the domain.*'block'" 2 check "$good" --set 'body.block.place.move=[0.5, 0, 0.2]'

# B28: values that spread
rejects "NaN" 'nan\.toml:2:11: error: spacing: must be a finite number, got nan' 2 run "$(scene nan 's/^spacing.*/spacing = nan/')"
rejects "infinity" 'inf\.toml:[0-9]+:[0-9]+: error: .*finite' 2 run "$(scene inf 's/young.*/young = inf/')"
rejects "text NaN" 'finite' 2 check "$(scene textnan 's/young.*/young = "nan Pa"/')"
rejects "spacing 0" 'spacing: must be > 0 m, got 0' 2 check "$(scene zero 's/^spacing.*/spacing = 0/')"
rejects "negative spacing" 'negative\.toml:2:11: error: spacing: must be > 0 m' 2 run "$(scene negative 's/^spacing.*/spacing = "-2 cm"/')"
rejects "Poisson's ratio 1/2" 'poisson: must be > -1 and < 0\.5' 2 run "$(scene poisson 's/young.*/&\npoisson = 0.5/')"
rejects "no mass" 'density: must be > 0 kg/m\^3' 2 run "$(scene mass 's/young.*/&\ndensity = 0/')"
rejects "below 0 K" 'temperature: must be > 0 K' 2 check "$(scene cold 's/^name = "block"/&\ntemperature = "-300 degC"/')"

# B29: less than there are ranks
accepts "one particle on three ranks" run "$good" --set 'body.block.box.size=[0.02, 0.02, 0.02]' --steps 3

# keys
rejects "unknown key" "keys\.toml:2:1: error: unknown key 'spacng'; did you mean 'spacing'\?" 2 run "$(scene keys 's/^spacing/spacng/')"
rejects "unknown override" "^--set spacng=3: error: unknown key 'spacng'; did you mean 'spacing'\?" 2 run "$good" --set spacng=3
rejects "override without a value" 'expected key=value' 2 check "$good" --set spacing
rejects "wrong unit" 'spacing: expected a length such as "2 mm", got "2 kg"' 2 check "$good" --set 'spacing=2 kg'
rejects "no such material" "there is no material 'jely'; did you mean 'jelly'\?" 2 run "$(scene material 's/material = .*/material = "jely"/')"
rejects "same name twice" "a second obstacle is called 'floor'" 2 check "$(scene twice '$a [[obstacle]]\nname = "floor"\nsphere = { radius = 0.01 }')"
rejects "nothing to do" 'there is nothing to simulate' 2 run "$(scene nothing '/\[\[body/,/^place/d')"

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

# meshes
mesh() { scene "$1" "s|^box.*|mesh = \"$1.$2\"|"; }
rejects "no such mesh" 'nomesh\.obj: there is no such file' 2 run "$(mesh nomesh obj)"
: >"$work/emptymesh.ply"
rejects "empty mesh" 'emptymesh\.ply: the file is empty' 2 check "$(mesh emptymesh ply)"
head -c 5000 "$thaw" >"$work/garbage.stl"
rejects "garbage mesh" 'garbage\.stl' 2 run "$(mesh garbage stl)"
printf 'ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n' >"$work/cutmesh.ply"
rejects "cut mesh" 'cutmesh\.ply' 2 run "$(mesh cutmesh ply)"
printf 'ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n' >"$work/vast.ply"
rejects "mesh that claims to be vast" 'vast\.ply' 2 run "$(mesh vast ply)"
printf 'v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n' >"$work/nanmesh.obj"
rejects "NaN in a mesh" 'nanmesh\.obj' 2 check "$(mesh nanmesh obj)"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >"$work/index.obj"
rejects "index beyond the vertices" 'index\.obj' 2 run "$(mesh index obj)"
printf 'v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\nf 1 3 2\n' >"$work/flat.obj"
rejects "mesh without volume" "flat\.obj|'block'" 2 run "$(mesh flat obj)"
printf 'v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n' >"$work/open.obj"
rejects "one triangle" "open\.obj|'block'" 2 run "$(mesh open obj)"

# sizes
printf 'v 0 0 0\nv 0.001 0 0\nv 0 0.001 0\nv 0 0 0.001\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >"$work/tiny.obj"
rejects "body without particles" "body 'block' has no particle" 2 run "$(mesh tiny obj)"
rejects "obstacle over everything" "inside an obstacle.*'block' and 'floor'" 2 run "$good" --set 'obstacle.floor.plane.point=[0, 0, 0.4]'
rejects "periodic and too short" 'periodic along x but shorter than three support radii' 2 check "$good" --set 'domain.sides.x=periodic' --set 'spacing=0.2'
rejects "more particles than ids" "body 'block' would take some .* particles" 2 run "$good" --set spacing=1e-9
rejects "more particles than memory" 'particles.* memory' 2 run "$good" --set spacing=2e-5
rejects "more particles than memory" 'particles.* memory' 2 check "$good" --set spacing=2e-5
printf 'spacing = 0.05\nend = 0.01\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n' >"$work/kinds.toml"
kinds() { { cat "$work/kinds.toml"; cat; } >"$work/$1.toml"; echo "$work/$1.toml"; }
rejects "oriented surface of tiny spacing" "surface.toml:6:1: error: oriented body 'ball': at a spacing of 1e-05 m .* particles, .*expected a spacing of at least" 2 run "$(kinds surface <<<"[[oriented]]
name = 'ball'
sphere = { radius = 0.4 }
spacing = 1e-5")"
rejects "sheet of tiny spacing" "sheet.toml:6:1: error: sheet 'cloth': at a spacing of 1e-09 m .* vertices, .*expected a spacing of at least" 2 check "$(kinds sheet <<<"[[sheet]]
name = 'cloth'
grid = { width = 0.4, depth = 0.4 }
spacing = 1e-9")"
rejects "wind on a sheet without mass" "windy.toml:10:.*wind_density.*expected mass > 0" 2 check "$(kinds windy <<<"[[sheet]]
grid = { width = 0.4, depth = 0.4 }
mass = 0
damping = 1
wind_density = 1.2
wind = [0, 0, 5]")"
rejects "springs on a sheet without mass and damping" "slack.toml:8:.*mass.*neither mass nor damping" 2 check "$(kinds slack <<<"[[sheet]]
grid = { width = 0.4, depth = 0.4 }
mass = 0
stiffness = 1000
warp = 1")"
rejects "emitter of tiny spacing" "emitter.toml:7:1: error: emitter 'tap': its opening has 3.6e\\+07 places" 2 check "$(kinds emitter <<<"[material.water]
[[emitter]]
name = 'tap'
material = 'water'
disc = { radius = 0.3 }")" --set spacing=1e-4

# what check and info say of a scene without continuum
patch=$(kinds patch <<<"[[oriented]]
patch = { width = 0.4, depth = 0.4 }")
checked() {
  isAccepted "check of oriented particles alone" check "$patch"
  grep -q 'by the materials alone' "$place/log" && fail "check: limits of materials where there are none"
}
described() {
  isAccepted "oriented particles alone" run "$patch" --steps 3
  "$thaw" info "$place/out" >"$place/info" || fail "info of oriented particles"
  grep -E -q '[1-9][0-9]*\.[0-9]{9}|\.0*[1-9][0-9]{8}' "$place/info" && fail "info: numbers of more than six digits"
  grep -q 'particles 0' "$place/log" && fail "progress shows particles that a scene without continuum has not"
  ls "$place/out/frames" | grep -v oriented && fail "frames of particles that a scene without continuum has not"
  "$thaw" render "$place/out" >"$place/log" 2>&1 || fail "render of oriented particles alone"
  [ -s "$place/out/pictures/patch_oriented_000000.png" ] || fail "no picture of oriented particles alone"
}
started checked
started described

# what of oriented bodies and sheets has no effect, or hardly can be meant: a warning
warns() { rejects "$1" "^warning: .*/$2" 0 check "$(kinds "$3" <<<"$4")"; }
plate="[[oriented]]
patch = { width = 0.4, depth = 0.4 }"
warns "a cut beside the body" "cut.toml:8:1: oriented body 'oriented 0': this cut has met nothing" cut "$plate
[[oriented.event]]
kind = 'cut'
plane = { point = [0.3, 0, 0], normal = [1, 0, 0] }"
warns "a crease beside the body" "crease.toml:8:1: .*this crease has met nothing" crease "$plate
[[oriented.event]]
kind = 'crease'
along = [[0, 0, 0.3], [0.1, 0, 0.3]]"
warns "a weld with what is far" "weld.toml:8:1: .*this weld has met nothing" weld "$plate
[[oriented.event]]
kind = 'weld'
other = 'far'
[[oriented]]
name = 'far'
patch = { width = 0.1, depth = 0.1 }
place = { move = [0, 0, 0.4] }"
cloth="[[sheet]]
grid = { width = 0.4, depth = 0.4 }"
warns "a sheet that is clamped" "clamped.toml:6:1: sheet 'sheet 0': all of its [0-9]+ vertices are clamped" clamped "$cloth
[[sheet.clamp]]
sphere = { radius = 0.6 }"
warns "a thick sheet" "thick.toml:6:1: sheet 'sheet 0': its thickness, 0.2 m, is more than three times the distance of its vertices, 0.056" thick "$cloth
thickness = 0.2"
warns "a sheet in an obstacle" "wall.toml:6:1: sheet 'sheet 0': [0-9]+ of its 81 vertices begin deeper than half of its thickness in the contact with obstacle 'ball'" wall "$cloth
[[obstacle]]
name = 'ball'
sphere = { radius = 0.05 }"
warns "a sheet in a body" "body.toml:6:1: sheet 'sheet 0': [0-9]+ of its 81 vertices begin inside body 'lump'" body "$cloth
[material.jelly]
young = '20 kPa'
[[body]]
name = 'lump'
material = 'jelly'
box = { size = [0.1, 0.1, 0.1] }"
warns "a sheet in another" "sheets.toml:8:1: sheet 'sheet 1': 81 of its 81 vertices begin nearer to sheet 'sheet 0' than 0.6 of the distance of contact" sheets "$cloth
$cloth
place = { move = [0.01, 0, 0.005] }"
warns "a sheet in a surface" "film.toml:8:1: sheet 'sheet 0': [0-9]+ of its 81 vertices begin nearer to oriented body 'oriented 0' than" film "$plate
$cloth
place = { rotate_x = 0.3 }"
warns "a surface in another" "films.toml:8:1: oriented body 'oriented 1': [0-9]+ of its [0-9]+ particles begin nearer to oriented body 'oriented 0' than" films "$plate
$plate
place = { move = [0, 0, 0.012] }"
drop="[material.oil]
[[body]]
material = 'oil'
sphere = { radius = 0.15 }
[surface]"
surfaceKey() {
  local file=surface_$1_${2/./_}
  warns "surface.$1 = $2" "$file.toml:11:[0-9]+: surface.$3.* sensible" "$file" "$drop
$1 = $2"
}
surfaceKey spacing 0.12 "spacing .0.12 m. is above spacing"
surfaceKey support 12 "support is 12: about 520 surfels"
surfaceKey support 1.5 "support is 1.5: about 8 surfels"
surfaceKey particle_support 3 "particle_support is 3: about 452 particles"
surfaceKey every_move 5 "every_move is 5"
surfaceKey implicit 0 "implicit is 0"
surfaceKey attract 1 "attract is 1"
surfaceKey smooth 0 "smooth is 0"
surfaceKey repel 0 "repel is 0"
surfaceKey iso_level 0.7 "iso_level is 0.7"
surfaceKey damping 1e-9 "damping is 1e-09"
surfaceKey damping 2 "damping is 2"
surfaceKey iterations 1 "iterations is 1"
surfaceKey stop 1 "stop is 1"
surfaceKey adapt 0.001 "adapt is 0.001: 1000000 surfels"
surfaceKey keep_volume 0.1 "keep_volume is 0.1"
surfaceKey link_length 4 "link_length is 4"
rejects "a surface far within its particles" "level.toml:11:[0-9]+: error: surface.iso_level.* 0.2 ... 0.8" 2 check "$(kinds level <<<"$drop
iso_level = 0.95")"
rejects "a surface that feels particles far away" "reach.toml:11:[0-9]+: error: surface.particle_support.* 1 ... 3" 2 check "$(kinds reach <<<"$drop
particle_support = 4")"
rejects "a sheet's mesh that is missing" "lost.toml:6:1: error: sheet 'sheet 0': .*nowhere.obj: there is no such file" 2 check "$(kinds lost <<<"[[sheet]]
mesh = 'nowhere.obj'")"
rejects "an oriented body's mesh that is missing" "lost2.toml:6:1: error: oriented body 'oriented 0': .*nowhere.obj: there is no such file" 2 check "$(kinds lost2 <<<"[[oriented]]
mesh = 'nowhere.obj'")"
rejects "an anchor's mesh that is missing" "lost3.toml:8:1: error: oriented body 'oriented 0': an anchor: .*nowhere.obj: there is no such file" 2 check "$(kinds lost3 <<<"$plate
[[oriented.anchor]]
mesh = 'nowhere.obj'")"
rejects "a clamp's mesh that is missing" "lost4.toml:8:1: error: sheet 'sheet 0': a clamp: .*nowhere.obj: there is no such file" 2 run "$(kinds lost4 <<<"$cloth
[[sheet.clamp]]
mesh = 'nowhere.obj'")"
rejects "the mesh of a body's clamp" "lost5.toml:[0-9]+:1: error: .*nowhere.obj" 2 check "$(scene lost5 '/^place/a [[body.clamp]]\nmesh = "nowhere.obj"')"
rejects "more particles than most" "most.toml:6:1: error: oriented body 'oriented 0': it begins with [0-9]+ particles and is to grow to .most. = 20; expected at least as many" 2 check "$(kinds most <<<"$plate
growth = 'gaps'
most = 20")"

# the command line
rejects "no such option" '--frobnicate' 2 run "$good" --frobnicate
rejects "negative steps" '--steps' 2 run "$good" --steps -1
rejects "restart of nothing" '--restart needs a checkpoint' 2 run "$good" --restart
allEnded
echo "$cases cases"
finish
