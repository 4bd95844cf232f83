#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Sheets (scenes/sheet/) have the same bits on 1, 2, 3, 4 and 7 ranks and after a rollback. A kill with -9,
# resumed on another number of ranks, does not change them. Covers vertices, ledger, and frames with their
# triangles. SCENES selects scenes.
. "$(dirname "$0")/../support/run.sh"
same() { sameRuns "$1" "$2" "$3" "frames/${scene}_sheet.hdf.series"; }  # same A B WHAT
# try SCENE STEPS SETTINGS: on all ranks, stopped, killed and resumed
try() {
  scene=$1
  local steps=$2 file=$scenes/sheet/$1.toml
  [ -f "$file" ] || file=$scenes/$1.toml
  [ -f "$file" ] || file=$work/$1.toml
  shift 2
  # frequent snapshots, so that a checkpoint is written often
  sameOnAllRanks "$scene" "$steps" killed "$file" --set numerics.retry_every=10 "$@"
  rm -rf "${work:?}/$scene".*
}
# Water falls on a cloth that is coarser than the water: contact by triangles. Another cloth hangs in the
# wind.
cat >"$work/coarse.toml" <<'EOF'
spacing = "2 cm"
end = "1 s"
[domain]
min = [-0.5, -0.5, -0.6]
max = [0.5, 0.5, 0.5]
[material.water]
density = 1000
viscosity = "0.5 Pa s"
sound_speed = "20 m/s"
conductivity = 10
[[body]]
name = "block"
box = { size = [0.2, 0.2, 0.12] }
material = "water"
temperature = 350
place = { move = [0.02, 0, 0.11] }
[[sheet]]
name = "cloth"
grid = { width = 0.6, depth = 0.5 }
spacing = "5 cm"
mass = 1
warp = 2000
weft = 2000
shear = 300
conductance = 300
temperature = 300
place = { rotate_z = "20 deg" }
[[sheet.clamp]]
difference = [ { box = { size = [1, 1, 0.1] } }, { box = { size = [0.45, 0.4, 0.2] } } ]
[[sheet]]
name = "under"
grid = { width = 0.3, depth = 0.3 }
spacing = "3 cm"
mass = 1
warp = 200
weft = 200
place = { move = [0, 0, -0.1] }
wind = [2, 0, 3]
wind_density = 1.2
[output]
every = "20 ms"
EOF
# A cloth comes down on its edge, folds, and falls on a ribbon that slides under it.
cat >"$work/folded.toml" <<'EOF'
spacing = "2 cm"
end = "1 s"
[domain]
min = [-0.5, -0.5, -0.02]
max = [0.5, 0.5, 0.5]
[[obstacle]]
name = "floor"
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
[[sheet]]
name = "cloth"
grid = { width = 0.3, depth = 0.3 }
spacing = "2 cm"
mass = 0.3
warp = 100
weft = 100
shear = 5
bending = 0.05
self_contact = true
place = { rotate_x = "86 deg", rotate_z = "25 deg", move = [0, 0, 0.165] }
velocity = [0, 0.3, -1]
[[sheet]]
name = "ribbon"
grid = { width = 0.2, depth = 0.06 }
spacing = "15 mm"
mass = 0.2
warp = 50
weft = 50
shear = 5
place = { rotate_z = "40 deg", move = [0.05, 0.1, 0.03] }
velocity = [-0.5, 0, 0]
[output]
every = "20 ms"
EOF
# Sheets wrap a block, a net and another sheet, with coefficients that vary in time and by region.
cat >"$work/wrapped.toml" <<'EOF'
spacing = "3 cm"
end = "1 s"
[domain]
min = [-0.6, -0.6, -0.6]
max = [0.6, 0.6, 0.6]
[material.rubber]
young = "50 kPa"
[[body]]
name = "block"
box = { size = [0.2, 0.2, 0.2] }
material = "rubber"
[[oriented]]
name = "net"
patch = { width = 0.4, depth = 0.3 }
density = 3
place = { move = [0, 0, -0.3] }
[[sheet]]
name = "round"
sphere = { radius = 0.25 }
spacing = "3 cm"
mass = 1
warp = 40
weft = 30
shear = 20
bending = 1
rest_length = 0.8
shrink_wrap = 30
shrink_wrap_to = "block"
shrink_wrap_in_time = [[0, 0.2], [0.1, 1]]
warp_in_time = [[0, 1], [0.2, 2]]
bending_in_time = [[0, 1], [0.1, 0]]
damping = 2
[[sheet.region]]
box = { size = [0.3, 1, 1] }
place = { move = [0.15, 0, 0] }
warp = 2
shrink_wrap = 0.5
damping = 3
[[sheet]]
name = "over"
grid = { width = 0.4, depth = 0.4 }
spacing = "4 cm"
mass = 0.5
shrink_wrap = 5
shrink_wrap_to = "net"
repulsion = 2
repulsion_in_time = [[0, 0], [0.1, 1]]
place = { move = [0, 0, -0.45] }
[[sheet]]
name = "beside"
grid = { width = 0.3, depth = 0.3 }
spacing = "4 cm"
mass = 0.5
shrink_wrap = 8
shrink_wrap_to = "round"
place = { rotate_y = "90 deg", move = [0.45, 0.01, 0] }
[output]
every = "20 ms"
EOF
wanted=${SCENES:-skin head jack shell cloth together coarse folded wrapped retry}
for which in $wanted; do
  case $which in
    skin)
      try skin 60 --set sheet.skin.spacing=0.004 --set output.every=0.01
      launch 2 run "$scenes/sheet/skin.toml" --out "$work/whole" >"$work/log" 2>&1
      expectExit 0 "skin to its end"  # 3 s
      grep "ledger does not close" "$work/log" && fail "skin: the ledger does not close" ;;
    head) try head 60 --set sheet.head.spacing=0.016 --set output.every=0.02 ;;
    jack) try jack 150 --set sheet.membrane.spacing=0.02 --set output.every=0.02 ;;
    shell) try shell 40 --set sheet.shell.spacing=0.008 ;;
    cloth)
      try cloth 900 --set sheet.cloth.spacing=0.03 --set spacing=0.012 --set sheet.cloth.thickness=0.02 \
        --set output.every=0.05
      ;;
    coarse) try coarse 250 ;;
    folded) try folded 1500 ;;
    wrapped) try wrapped 120 ;;
    together) try together 60 --set spacing=0.02 --set output.every=0.02 ;;
    retry)  # a step that is too long for the springs
      scene=head
      for ranks in 1 3 7; do
        launch $ranks run "$scenes/sheet/head.toml" --set sheet.head.spacing=0.016 \
          --set numerics.fixed_step=0.01 --set numerics.retry_every=10 --set end=0.3 \
          --out "$work/retry.$ranks" >"$work/log" 2>&1
        expectExit 0 "head with long steps on $ranks ranks"
        expectMessage "^warning: failed at step .*; back to step" "head with long steps on $ranks ranks"
        [ "$ranks" = 1 ] ||
          same "$work/retry.1" "$work/retry.$ranks" "head with long steps on 1 and $ranks ranks"
      done ;;
  esac
done
finish
