#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Impossible shapes, meshes and sizes.
. "$(dirname "$0")/../support/bad_input.sh"

# meshes
mesh() { scene "$1" "s|^box.*|mesh = \"$1.$2\"|"; }
rejects "no such mesh" 'nomesh\.toml:[0-9]+:8: error: .*nomesh\.obj: no such file' \
  2 run "$(mesh nomesh obj)"
: >"$work/emptymesh.ply"
rejects "empty mesh" 'emptymesh\.ply: the file is empty' 2 check "$(mesh emptymesh ply)"
head -c 5000 "$thaw" >"$work/garbage.stl"
rejects "garbage mesh" 'garbage\.stl' 2 run "$(mesh garbage stl)"
printf 'ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n'\
'end_header\n0 0 0\n' >"$work/cutmesh.ply"
rejects "cut mesh" 'cutmesh\.ply' 2 run "$(mesh cutmesh ply)"
printf 'ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n'\
'property float y\nproperty float z\nend_header\n' >"$work/vast.ply"
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
printf 'v 0 0 0\nv 0.001 0 0\nv 0 0.001 0\nv 0 0 0.001\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' \
  >"$work/tiny.obj"
rejects "body without particles" "body 'block' has no particle" 2 run "$(mesh tiny obj)"
rejects "a mesh of another unit, with a scale too many" \
  "has no particle.*; its size is 1e-06 x 1e-06 x 1e-06 m: without its place.scale of 0.001 it would be \
0.001 m high" 2 run "$(mesh tiny obj)" --set spacing=0.0001 --set body.block.place.scale=0.001 \
  --set domain.min='[-0.01, -0.01, -0.01]' --set domain.max='[0.01, 0.01, 0.01]'
printf 'v 0 0 0\nv 100 0 0\nv 0 200 0\nv 0 0 300\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >"$work/mm.obj"
rejects "a mesh in millimetres" \
  "body 'block': the bodies need about .* memory.*; its size is 100 x 200 x 300 m: \
if its file is in millimetres, set place = . scale = 0.001 ., else" 2 run "$(mesh mm obj)"
rejects "a mesh in centimetres" \
  "body 'block': the bodies need .*; its size is 100 x 200 x 300 m: if its file is in centimetres, \
set place = . scale = 0.01 ., else" 2 check "$(mesh mm obj)" --set spacing=0.2 --set domain.max='[4, 4, 4]'
rejects "a mesh that is too large in any unit" \
  "body 'block': .* lie outside of the domain, up to .* m beyond its side z = 4 m.*; \
its size is 10 x 20 x 30 m: set place.scale or place.height" 2 check "$(mesh mm obj)" --set spacing=0.5 \
  --set body.block.place.scale=0.1 --set domain.max='[4, 4, 4]'
rejects "a body that is narrower than the spacing" \
  "^warning: .*good.toml:9:1: body 'block' is narrower than the spacing of 0.02 m .0.01 m along z.: \
it becomes one layer of particles" 0 check "$good" --set body.block.box.size='[0.1, 0.1, 0.01]'
rejects "obstacle over everything" "inside obstacles \(first: of body 'block' in obstacle 'floor'\)" \
  2 run "$good" --set 'obstacle.floor.plane.point=[0, 0, 0.4]'
rejects "periodic and too short" \
  'periodic along x but shorter than three support radii: it is .* expected at least 1.2 m, 6 spacings: ' \
  2 check "$good" --set 'domain.sides.x=periodic' --set 'spacing=0.2'
rejects "more particles than ids" \
  "^--set spacing=1e-9: error: spacing: at 1e-09 m body 'block' would take about 1.0e.24 particles, \
at least 4.0e.17 GB of memory; use a coarser spacing" 2 run "$good" --set spacing=1e-9
rejects "more particles than memory" 'particles.* memory' 2 run "$good" --set spacing=2e-5
rejects "more particles than memory" 'particles.* memory' 2 check "$good" --set spacing=2e-5
# A bath of 8 layers in a tank of 7.2 spacings is compressed by the walls. A bath of 7.2 spacings has 7 layers
# and fits, as does one of 8 in a tank of 8.
tank() {
  bodyTypes "$1" <<SCENE
[material.water]
[[body]]
name = 'bath'
material = 'water'
box = { size = [$2, $2, $2] }
[[obstacle]]
name = 'tank'
difference = [ { box = { size = [0.8, 0.8, 0.8] } }, { box = { size = [${3:-$2}, ${3:-$2}, 1] } } ]
SCENE
}
rejects "a bath that is pressed into its tank" \
  "^warning: .*bath.toml:7:1: body 'bath': its liquid starts compressed by up to [0-9]+ % and would burst at \
about [0-9.]+ m/s" 0 check "$(tank bath 0.4 0.36)" --set quality=preview
ring() {
  bodyTypes ring <<SCENE
[material.water]
[[body]]
name = 'ring'
material = 'water'
difference = [ { box = { size = [0.4, 0.4, 0.4] } }, { box = { size = [0.12, 0.12, 1] } } ]
[[obstacle]]
name = 'pillar'
box = { size = [0.15, 0.15, 1] }
SCENE
}
rejects "a bath that is pressed onto a pillar" \
  "^warning: .*body 'ring': its liquid starts compressed by .* enlarge the cut-out by half a spacing" \
  0 check "$(ring)" --set quality=preview
fits() {
  local size
  for size in 0.4 0.36; do
    isAccepted "a bath of $size m that fits" check "$(tank "fits$size" "$size")"
    grep 'starts compressed' "$place/log" && fail "a bath of $size m that fits starts compressed"
  done
}
started fits

allCases
