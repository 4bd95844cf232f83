#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A restart with another scene. Changes to the initial particles and vertices are refused with the key, both
# values and the line. Changes with a later effect are reported. No restart crashes. Meshes are compared by
# content.
. "$(dirname "$0")/../support/run.sh"
squares() {  # squares N: a mesh of N by N squares over half a metre
  awk -v n="$1" 'BEGIN {
    for (j = 0; j <= n; j++) for (i = 0; i <= n; i++)
      printf "v %.6f %.6f 0\n", i / n / 2 - 0.25, j / n / 2 - 0.25
    for (j = 0; j < n; j++) for (i = 0; i < n; i++) {
      a = j * (n + 1) + i + 1
      print "f", a, a + 1, a + n + 2
      print "f", a, a + n + 2, a + n + 1
    }
  }'
}
squares 10 >"$work/cloth.obj"
squares 6 >"$work/coarse.obj"
sed '1s/.*/v -0.26 -0.25 0/' "$work/cloth.obj" >"$work/other.obj"
cat >"$work/all.toml" <<'END'
spacing = 0.05
end = 0.5
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[material.jelly]
density = 1000
young = "20 kPa"
[[body]]
name = "block"
box = { size = [0.2, 0.2, 0.2] }
place = { move = [0, 0, -0.3] }
material = "jelly"
[[obstacle]]
name = "floor"
plane = { point = [0, 0, -0.6], normal = [0, 0, 1] }
[[sheet]]
name = "cloth"
mesh = "cloth.obj"
place = { move = [0, 0, 0.1] }
mass = 0.3
damping = 1
warp = 50
weft = 50
shear = 5
shrink_wrap = 3
shrink_wrap_to = "block"
[[sheet.region]]
plane = { point = [0, 0, 0], normal = [1, 0, 0] }
warp = 3
[[sheet.pressure_brush]]
radius = 0.2
pressure = [0, 0, 20]
motion = [{ time = 0 }, { time = 0.5, move = [0.3, 0, 0] }]
[[oriented]]
name = "net"
patch = { width = 0.5, depth = 0.5 }
place = { move = [0, 0, 0.4] }
[[oriented.constraint]]
plane = { point = [-0.2, 0, 0], normal = [1, 0, 0] }
[[oriented.event]]
kind = "cut"
time = 0.001
plane = { point = [0.1, 0, 0] }
[output]
every = 0.1
END
launch 2 run "$work/all.toml" --steps 60 --out "$work/first" >"$work/log" 2>&1; expectExit 0 "first part"
expectMessage '^  spacing 0.05 m; quality standard$' "first part"
again() {  # again RANKS EXIT WHAT OPTIONS...: a restart of a copy of the first part
  local ranks=$1 code=$2 what=$3
  shift 3
  rm -rf "$work/run"
  cp -r "$work/first" "$work/run"
  launch "$ranks" run "$work/all.toml" --steps 65 --restart --out "$work/run" "$@" >"$work/log" 2>&1
  expectExit "$code" "$what"
}
again 2 0 "the same scene"
expectMessage '^  spacing 0.05 m; quality standard$' "the same scene"
grep -q '^warning: changed' "$work/log" && fail "the same scene: a change is reported"
mkdir "$work/elsewhere" && cp "$work/cloth.obj" "$work/elsewhere/moved.obj"
again 2 0 "the mesh in another folder" --set "sheet.cloth.mesh=\"$work/elsewhere/moved.obj\""
grep -q '^warning: changed' "$work/log" && fail "the mesh in another folder: a change is reported"

refuses() {
  again "$1" 2 "$3" --set "$3"
  expectMessage 'cannot continue with this scene. Values that must not change' "$3"
  expectMessage "$2" "$3"
}
refuses 3 '^  sheet.cloth.mesh: 121 vertices .* -> 49 vertices .* (.*all.toml:17)' \
  "sheet.cloth.mesh=\"$work/coarse.obj\""
refuses 1 '^  sheet.cloth.mesh: 121 vertices .* -> 121 vertices .*' \
  "sheet.cloth.mesh=\"$work/other.obj\""
refuses 2 '^  sheet.cloth.region.0.plane.point: .0, 0, 0. -> .0.1, 0, 0. m (.*all.toml:28)' \
  'sheet.cloth.region.0.plane.point=[0.1,0,0]'
refuses 2 '^  oriented.net.constraint.0.plane.point: .-0.2, 0, 0. -> .-0.1, 0, 0.' \
  'oriented.net.constraint.0.plane.point=[-0.1,0,0]'
refuses 2 '^  body.block.box.size: .0.2, 0.2, 0.2. -> .0.3, 0.2, 0.2. m' \
  'body.block.box.size=[0.3,0.2,0.2]'
cp "$work/cloth.obj" "$work/kept.obj" && cp "$work/coarse.obj" "$work/cloth.obj"
again 3 2 "another mesh under the same name"
expectMessage '^  sheet.cloth.mesh: 121 vertices .* -> 49 vertices .*' \
  "another mesh under the same name"
mv "$work/kept.obj" "$work/cloth.obj"
again 2 2 "heat, where there was none" --set sheet.cloth.conductance=5
expectMessage "cannot continue.*A changed key needs data that the checkpoint lacks: .*no field 'enthalpy'" \
  "heat, where there was none"
expectMessage '^  sheet.cloth.conductance: 0 -> 5' "heat, where there was none"
grep -q '^warning: changed at the restart' "$work/log" &&
  fail "heat, where there was none: reported before it is refused"

tells() { again "${3:-2}" 0 "$2" --set "$2"; expectMessage "^warning: changed at the restart: $1" "$2"; }
again 2 0 "another quality" --set quality=preview
expectMessage '^  spacing 0.05 m; quality preview (--set quality=preview)$' "another quality"
again 2 2 "another spacing" --set spacing=0.04
expectMessage '^  spacing 0.04 m; quality standard (--set spacing=0.04)$' "another spacing"
tells 'sheet.cloth.shrink_wrap_to: "block" -> "net"' 'sheet.cloth.shrink_wrap_to="net"'
tells 'sheet.cloth.pressure_brush.0.motion.1.move: .0.3, 0, 0. -> .0.2, 0, 0. m' \
  'sheet.cloth.pressure_brush.0.motion=[{time=0},{time=0.5,move=[0.2,0,0]}]'
tells 'oriented.net.cfl: 0.25 -> 0.2' 'oriented.net.cfl=0.2'
tells 'obstacle.floor.plane.point: .0, 0, -0.6. -> .0, 0, -0.7. m' \
  'obstacle.floor.plane.point=[0,0,-0.7]' 3
tells 'obstacle.floor.motion.1.move: not in the scene -> .0, 0, 0.1. m' \
  'obstacle.floor.motion=[{time=0},{time=1,move=[0,0,0.1]}]'
tells 'domain.sides.z.low: "open" -> "wall"' 'domain.sides={z=["wall","open"]}'
tells 'numerics.cfl_elastic: .* -> 0.2' 'numerics.cfl_elastic=0.2'
again 2 0 "an event that has been" --set oriented.net.event.0.time=0.0005
expectMessage \
  '^warning: changed at the restart, without effect, since its time has passed: oriented.net.event.0.time'\
': 0.001 -> 0.0005 s' "an event that has been"
events='{kind="cut",time=0.4,plane={point=[0,0,0]}},{kind="cut",time=0.001,plane={point=[0.1,0,0]}}'
again 2 2 "a cut before one that has been made" --set "oriented.net.event=[$events]"
expectMessage 'oriented.net.event.0: .* add new cuts after' "a cut before one that has been made"
finish
