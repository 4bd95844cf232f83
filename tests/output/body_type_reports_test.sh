#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Reports of commands for scenes with oriented particles and sheets only: the limit that a failure exceeded,
# numbers of particles, fields, and changes at a restart.
. "$(dirname "$0")/../support/run.sh"
cat >"$work/net.toml" <<'END'
spacing = 0.05
end = 0.05
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[[oriented]]
name = "net"
patch = { width = 0.5, depth = 0.5 }
growth = "borders"
most = 300
every = 1
velocity = [0, 0, 1]
[[oriented.constraint]]
box = { size = [0.06, 1, 1] }
place = { move = [-0.25, 0, 0] }
[[oriented.constraint.motion]]
time = 0
[[oriented.constraint.motion]]
time = 0.05
move = [-0.3, 0, 0]
[[oriented.event]]
kind = "cut"
time = 0.04
plane = { point = [0.1, 0, 0] }
[output]
every = 0.01
END
launch 2 check "$work/net.toml" >"$work/log" 2>&1; expectExit 0 "check"
start=$(sed -n "s/.*oriented body 'net': \([0-9]*\) particles/\1/p" "$work/log")
launch 2 run "$work/net.toml" --steps 20 --out "$work/net" >"$work/log" 2>&1; expectExit 0 "run"
[ -n "$start" ] && grep -q "oriented: $start particles" "$work/log" ||
  fail "check counts $start particles, and the run begins with $(grep 'oriented:' "$work/log")"
launch 2 run "$work/net.toml" --restart --set oriented.net.event.0.time=0.045 --out "$work/net" \
  >"$work/log" 2>&1
expectExit 0 "restart with another event"
expectMessage "changed at the restart: oriented.net.event.0.time: 0.04 -> 0.045 s" \
  "restart with another event"
launch 2 run "$work/net.toml" \
  --set 'oriented.net.field=[{acceleration=[0,0,1],box={size=[0.1,0.1,0.1]},place={move=[0,0,0.8]}}]' \
  --steps 2 --out "$work/idle" >"$work/log" 2>&1
expectExit 0 "a field without particles"
expectMessage "warning: .*oriented body 'net': no particle is in this field as it begins, at 0 s" \
  "a field without particles"
"$thaw" render "$work/net" --field warmth >"$work/log" 2>&1; expectExit 3 "a field that is not there"
expectMessage "no field 'warmth'; there are: .*velocity" "a field that is not there"
"$thaw" render "$work/net" --what surface >"$work/log" 2>&1; expectExit 3 "no surface"
expectMessage \
  "no surface frames in this folder, only frames of particles, sheets or oriented particles; \
a scene has a surface with a table .surface." "no surface"

cat >"$work/leaf.toml" <<'END'
spacing = 0.05
end = 2
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[[sheet]]
name = "leaf"
grid = { width = 0.5, depth = 0.5 }
warp = 20000
weft = 20000
rest_length = 0.9
[output]
every = 0.5
END
launch 2 run "$work/leaf.toml" --set numerics.fixed_step=0.002 --set numerics.retry_every=5 \
  --set numerics.retries=0 --out "$work/leaf" >"$work/log" 2>&1
expectExit 4 "a step far too long"
expectMessage \
  "blew up at step .*unexplained gain of mechanical energy since .*numerics.watch_energy.*; the fastest one: \
vertex [0-9]* of 'leaf' at" "a step far too long"
regions='sheet.leaf.region=[{box={size=[0.2,0.2,0.1]},weft=3},{box={size=[0.3,0.3,0.1]},warp=2}]'
launch 2 run "$work/leaf.toml" --steps 2 --set "$regions" --out "$work/regions" >"$work/log" 2>&1
expectExit 0 "regions on each other"
expectMessage \
  "warning: .*sheet 'leaf': [0-9]* vertices lie in regions 0 and 1. Region 1 applies there; \
weft of region 0 is ignored. Set it in region 1, too" "regions on each other"
launch 2 run "$work/leaf.toml" --steps 2 --out "$work/leaf" >"$work/log" 2>&1; expectExit 0 "leaf"
"$thaw" render "$work/leaf" --field warmth >"$work/log" 2>&1; expectExit 3 "a field that sheets have not"
expectMessage "no field 'warmth'; there are: .*velocity" "a field that sheets have not"

printf '[[sheet]]\nname = "twig"\ngrid = { width = 0.1, depth = 0.1 }\nplace = { move = [0, 0, 0.5] }\n' |
  cat "$work/leaf.toml" - >"$work/leaves.toml"
launch 1 check "$work/leaves.toml" >"$work/log" 2>&1; expectExit 0 "check of two sheets"
expectMessage "^  sheets: sheets 'leaf' and 'twig'" "check of two sheets"

# A curve next to a surface is drawn, although no triangle shows it. A negative number may begin with its
# point.
cat >"$work/curve.toml" <<'END'
spacing = 0.05
end = 1
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[[oriented]]
name = "patch"
patch = { width = 0.4, depth = 0.4 }
END
cp "$work/curve.toml" "$work/patch.toml"
printf '[[oriented]]\nname = "line"\ncurve = { from = [-0.4, 0.5, 0], to = [0.4, 0.5, 0] }\n' \
  >>"$work/curve.toml"
for scene in patch curve; do
  launch 1 run "$work/$scene.toml" --steps 0 --out "$work/$scene" >"$work/log" 2>&1; expectExit 0 "$scene"
  "$thaw" render "$work/$scene" --from -.2 -1.5 .9 --at 0 .2 0 --width 160 --height 120 \
    --out "$work/$scene.pictures" >"$work/log" 2>&1
  expectExit 0 "picture of $scene"
done
cmp -s "$work"/patch.pictures/*.png "$work"/curve.pictures/*.png &&
  fail "the curve beside the patch is not in the picture"

cat >"$work/skin.toml" <<'END'
spacing = 0.02
end = 0.002
[domain]
min = [-0.3, -0.3, -0.3]
max = [0.3, 0.3, 0.3]
[material.jelly]
density = 1000
young = "40 kPa"
[[body]]
name = "ball"
sphere = { radius = 0.06 }
material = "jelly"
[[sheet]]
name = "cloth"
grid = { width = 0.2, depth = 0.2 }
place = { move = [0, 0, 0.15] }
[surface]
[output]
every = 0.001
END
launch 2 run "$work/skin.toml" --out "$work/skin" >"$work/log" 2>&1; expectExit 0 "a surface beside a sheet"
for field in "" "--field velocity" "--field surface" "--field none"; do  # shellcheck disable=SC2086
  "$thaw" render "$work/skin" $field >"$work/log" 2>&1
  expectExit 0 "pictures of a surface beside a sheet, $field"
done
"$thaw" render "$work/skin" --field warmth >"$work/log" 2>&1; expectExit 3 "a field that neither has"
expectMessage "no field 'warmth'; there are: .*velocity" "a field that neither has"
finish
