#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Oriented bodies, sheets and emitters that are invalid or implausible.
. "$(dirname "$0")/../support/bad_input.sh"

printf 'v 0 0 0\nv 0.5 0 0\nv 0 0.5 0\nv 0 0 0.5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >"$work/box.obj"
rejects "oriented surface of tiny spacing" \
  "surface.toml:6:1: error: oriented body 'ball': at a spacing of 1e-05 m .* particles, \
.*expected a spacing of at least" 2 run "$(bodyTypes surface <<<"[[oriented]]
name = 'ball'
sphere = { radius = 0.4 }
spacing = 1e-5")"
rejects "sheet of tiny spacing" \
  "sheet.toml:6:1: error: sheet 'cloth': at a spacing of 1e-09 m .* vertices, \
.*expected a spacing of at least" 2 check "$(bodyTypes sheet <<<"[[sheet]]
name = 'cloth'
grid = { width = 0.4, depth = 0.4 }
spacing = 1e-9")"
rejects "oriented surface far too fine for the domain's cells, too" \
  "far.toml:6:1: error: oriented body 'ball': at a spacing of 1e-09 m .* particles, which take at least .* \
GB" 2 check "$(bodyTypes far <<<"[[oriented]]
name = 'ball'
sphere = { radius = 0.4 }
spacing = 1e-9")"
rejects "oriented surface of a file far too fine" \
  "far2.toml:6:1: error: oriented body 'ball': at a spacing of 1e-05 m .* particles, which take .* \
GB on a machine" 2 check "$(bodyTypes far2 <<<"[[oriented]]
name = 'ball'
mesh = '$work/box.obj'
spacing = 1e-5")"
rejects "sheet of the scene's tiny spacing" \
  "^--set spacing=1e-9: error: spacing: sheet 'cloth': at a spacing of 1e-09 m .* vertices, \
which take at least .* GB" 2 run "$(bodyTypes sheet2 <<<"[[sheet]]
name = 'cloth'
grid = { width = 0.4, depth = 0.4 }")" --set spacing=1e-9
welded="[[oriented]]
name = 'a'
patch = { width = 0.4, depth = 0.4 }
[[oriented.event]]
kind = 'weld'
time = 0.001
other = 'b'
[[oriented]]
name = 'b'
patch = { width = 0.1, depth = 0.4 }
place = { move = [0.3, 0, 0] }"
welds() { rejects "$1" "$2" 2 "$3" "$(bodyTypes "$4" <<<"$welded
$5")"; }
after="was merged into 'a' by the weld at 0.001 s .line 9."
cut="[[oriented.event]]
kind = 'cut'
plane = { point = [0.3, 0, 0] }"
welds "a cut of what was welded away" \
  "late.toml:17:1: error: oriented body 'b': it $after: move this cut at 0.002 s to 'a', \
or before that weld" check late "$cut
time = 0.002"
welds "the same in a run" "late2.toml:17:1: error: oriented body 'b': it $after" run late2 "$cut
time = 0.002"
welds "a weld of what was welded away" \
  "late3.toml:20:1: error: oriented body 'c': this weld at 0.002 s names 'b', which $after: \
expected other = .a., or a time before that weld" check late3 "[[oriented]]
name = 'c'
patch = { width = 0.1, depth = 0.4 }
[[oriented.event]]
kind = 'weld'
other = 'b'
time = 0.002"
accepts "a cut before the weld" check "$(bodyTypes early <<<"$welded
$cut")"
rejects "wind on a sheet without mass" "windy.toml:10:.*wind_density.*expected .mass. > 0" \
  2 check "$(bodyTypes windy <<<"[[sheet]]
grid = { width = 0.4, depth = 0.4 }
mass = 0
damping = 1
wind_density = 1.2
wind = [0, 0, 5]")"
rejects "springs on a sheet without mass and damping" "slack.toml:8:.*mass: a massless, undamped vertex" \
  2 check "$(bodyTypes slack <<<"[[sheet]]
grid = { width = 0.4, depth = 0.4 }
mass = 0
stiffness = 1000
warp = 1")"
rejects "emitter of tiny spacing" \
  "emitter.toml:7:1: error: emitter 'tap': its opening has 3.6e\\+07 particle positions" \
  2 check "$(bodyTypes emitter <<<"[material.water]
[[emitter]]
name = 'tap'
material = 'water'
disc = { radius = 0.3 }")" --set spacing=1e-4
rejects "emitter outside" \
  "above.toml:7:1: error: emitter 'tap': [0-9]+ of its [0-9]+ positions of a layer lie outside of the \
domain, up to 0.5 m beyond its side z = 1 m; enlarge the domain or move the emitter" \
  2 run "$(bodyTypes above <<<"[material.water]
[[emitter]]
name = 'tap'
material = 'water'
centre = [0, 0, 1.5]
disc = { radius = 0.3 }")"

rejects "emitter in an obstacle" \
  "sunk.toml:7:1: error: emitter 'tap': [0-9]+ of its [0-9]+ positions of a layer lie in obstacle 'block'; \
move the emitter" 2 check "$(bodyTypes sunk <<<"[material.water]
[[emitter]]
name = 'tap'
material = 'water'
disc = { radius = 0.2 }
[[obstacle]]
name = 'block'
box = { size = [0.5, 0.5, 0.5] }")"
warns "a narrow emitter" \
  "thin.toml:7:1: emitter 'tap' emits [0-9.]+ kg/s, but opening, speed and density imply [0-9.]+ kg/s" thin \
  "[material.water]
[[emitter]]
name = 'tap'
material = 'water'
rectangle = { width = 0.4, depth = 0.01 }"
warns "a clamp that holds nothing" "loose.toml:8:1: body 'bar': its clamp contains none of its particles" \
  loose "[material.rubber]
young = '1 MPa'
[[body]]
name = 'bar'
material = 'rubber'
box = { size = [0.3, 0.1, 0.1] }
[[body.clamp]]
box = { size = [0.1, 0.1, 0.1] }
place = { move = [0.6, 0, 0] }"
warns "one of two clamps that holds nothing" \
  "half.toml:8:1: body 'bar': its clamp 2 of 2 contains none of its particles$" half "[material.rubber]
young = '1 MPa'
[[body]]
name = 'bar'
material = 'rubber'
box = { size = [0.3, 0.1, 0.1] }
clamp = [ { box = { size = [0.2, 0.1, 0.1] }, place = { move = [-0.1, 0, 0] } },
  { box = { size = [0.1, 0.1, 0.1] }, place = { move = [0.6, 0, 0] } } ]"
warns "what melts without heat" "ice.toml:6:1: material 'ice' melts, but nothing changes its temperature" \
  ice "[material.ice]
young = '1 MPa'
melts = '0 degC'
heat_capacity = '2 kJ/(kg K)'
[[body]]
name = 'block'
material = 'ice'
box = { size = [0.2, 0.2, 0.2] }
temperature = '-5 degC'"

# output of check and info for a scene without continuum
patch=$(bodyTypes patch <<<"[[oriented]]
patch = { width = 0.4, depth = 0.4 }")
checked() {
  isAccepted "check of oriented particles alone" check "$patch"
  grep -q 'by the materials alone' "$place/log" && fail "check: limits of materials where there are none"
}
described() {
  isAccepted "oriented particles alone" run "$patch" --steps 3
  "$thaw" info "$place/out" >"$place/info" || fail "info of oriented particles"
  grep -E -q '[1-9][0-9]*\.[0-9]{9}|\.0*[1-9][0-9]{8}' "$place/info" &&
    fail "info: numbers of more than six digits"
  grep -q 'particles 0' "$place/log" && fail "progress shows particles that a scene without continuum has not"
  ls "$place/out/frames" | grep -v oriented &&
    fail "frames of particles that a scene without continuum has not"
  "$thaw" render "$place/out" >"$place/log" 2>&1 || fail "render of oriented particles alone"
  [ -s "$place/out/pictures/patch_oriented_000000.png" ] || fail "no picture of oriented particles alone"
}
started checked
started described

# ineffective or implausible settings of oriented bodies and sheets: a warning
plate="[[oriented]]
patch = { width = 0.4, depth = 0.4 }"
warns "a cut beside the body" "cut.toml:8:1: oriented.0: this cut has no effect" cut "$plate
[[oriented.event]]
kind = 'cut'
plane = { point = [0.3, 0, 0], normal = [1, 0, 0] }"
warns "a crease beside the body" "crease.toml:8:1: .*this crease has no effect" crease "$plate
[[oriented.event]]
kind = 'crease'
along = [[0, 0, 0.3], [0.1, 0, 0.3]]"
warns "a weld with what is far" "weld.toml:8:1: .*this weld has no effect" weld "$plate
[[oriented.event]]
kind = 'weld'
other = 'far'
[[oriented]]
name = 'far'
patch = { width = 0.1, depth = 0.1 }
place = { move = [0, 0, 0.4] }"
cloth="[[sheet]]
grid = { width = 0.4, depth = 0.4 }"
warns "a sheet that is clamped" "clamped.toml:6:1: sheet.0: all of its [0-9]+ vertices are clamped" \
  clamped "$cloth
[[sheet.clamp]]
sphere = { radius = 0.6 }"
warns "a thick sheet" \
  "thick.toml:6:1: sheet.0: its thickness, 0.2 m, is more than three times its vertex spacing, \
0.056" thick "$cloth
thickness = 0.2"
warns "a sheet in an obstacle" \
  "wall.toml:6:1: sheet.0: [0-9]+ of its 81 vertices overlap obstacle 'ball' by more than half of \
their thickness" wall "$cloth
[[obstacle]]
name = 'ball'
sphere = { radius = 0.05 }"
warns "a sheet that touches a floor" \
  "floor.toml:6:1: sheet.0: 81 of its 81 vertices start within its contact distance, 0.04 m, \
of obstacle 'floor': contact will push them apart" floor "$cloth
thickness = 0.04
[[obstacle]]
name = 'floor'
plane = { point = [0, 0, -0.03], normal = [0, 0, 1] }"
warns "a sheet that touches another" \
  "near.toml:9:1: sheet.1: [0-9]+ of its 81 vertices start within its contact distance, 0.04 m, \
of sheet.0: contact will push them apart" near "$cloth
thickness = 0.04
$cloth
thickness = 0.04
place = { move = [0.02, 0.02, 0.03] }"
warns "a sheet that touches a body" \
  "lies.toml:6:1: sheet.0: [0-9]+ particles start within its contact distance, [0-9.]+ m, \
of body 'cube': contact will push them apart" lies "$cloth
[material.jelly]
young = '20 kPa'
[[body]]
name = 'cube'
material = 'jelly'
box = { size = [0.1, 0.1, 0.1] }
place = { move = [0, 0, -0.06] }"
warns "a sheet that touches a surface" \
  "rests.toml:8:1: sheet.0: [0-9]+ of its 81 vertices start within its contact distance, [0-9.]+ m, \
of oriented.0: contact will push them apart" rests "$plate
$cloth
place = { move = [0, 0, 0.035] }"
lump="$cloth
[material.jelly]
young = '20 kPa'
melts = '350 K'
heat_capacity = 1000
[[body]]
name = 'lump'
material = 'jelly'
box = { size = [0.1, 0.1, 0.1] }"
rejects "a sheet in a body" \
  "body.toml:6:1: error: sheet.0: [0-9]+ of its 81 vertices start inside body 'lump', \
where they would stay trapped; move them apart, or set .numerics.overlap" \
  2 check "$(bodyTypes body <<<"$lump")"
warns "a sheet in a body that is to be" \
  "kept.toml:6:1: sheet.0: [0-9]+ of its 81 vertices start inside body 'lump'; \
contact traps them there: move the bodies apart" kept "$lump
[numerics]
overlap = 'keep'"
warns "a sheet in a liquid" \
  "bath.toml:6:1: sheet.0: [0-9]+ of its 81 vertices start inside body 'lump'; \
contact will push the liquid of body 'lump' away" bath "$lump
temperature = 400"
warns "a sheet in another" \
  "sheets.toml:8:1: sheet.1: 81 of its 81 vertices start nearer to sheet.0 than 0.6 of the \
contact distance" sheets "$cloth
$cloth
place = { move = [0.01, 0, 0.005] }"
warns "a sheet in a surface" \
  "film.toml:8:1: sheet.0: [0-9]+ of its 81 vertices start nearer to oriented.0 \
than" film "$plate
$cloth
place = { rotate_x = 0.3 }"
warns "a surface in another" \
  "films.toml:8:1: oriented.1: [0-9]+ of its [0-9]+ particles start nearer to oriented.0 \
than" films "$plate
$plate
place = { move = [0, 0, 0.012] }"
rejects "a sheet's mesh that is missing" \
  "lost.toml:6:1: error: sheet.0: .*nowhere.obj: no such file" \
  2 check "$(bodyTypes lost <<<"[[sheet]]
mesh = 'nowhere.obj'")"
rejects "an oriented body's mesh that is missing" \
  "lost2.toml:7:8: error: oriented.0: .*nowhere.obj: no such file" \
  2 check "$(bodyTypes lost2 <<<"[[oriented]]
mesh = 'nowhere.obj'")"
rejects "a constraint's mesh that is missing" \
  "lost3.toml:9:8: error: oriented.0: a constraint: .*nowhere.obj: no such file" \
  2 check "$(bodyTypes lost3 <<<"$plate
[[oriented.constraint]]
mesh = 'nowhere.obj'")"
rejects "a clamp's mesh that is missing" \
  "lost4.toml:9:8: error: sheet.0: a clamp: .*nowhere.obj: no such file" \
  2 run "$(bodyTypes lost4 <<<"$cloth
[[sheet.clamp]]
mesh = 'nowhere.obj'")"
rejects "the mesh of a body's clamp" "lost5.toml:[0-9]+:8: error: .*nowhere.obj" \
  2 check "$(scene lost5 '/^place/a [[body.clamp]]\nmesh = "nowhere.obj"')"
rejects "more particles than most" \
  "most.toml:6:1: error: oriented.0: it starts with [0-9]+ particles and .most. is 20; \
expected .most. to be at least the initial number" 2 check "$(bodyTypes most <<<"$plate
growth = 'gaps'
most = 20")"

allCases
