#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# `thaw export` in all formats, read by three.js, tinyusdz, OpenVDB's Python module, h5py, Partio,
# ParaView and Blender. It lists missing readers at its end, and is skipped if all are missing.
# MODULES=DIR: node_modules with the readers of USD.
. "$(dirname "$0")/../support/run.sh"
MODULES=${MODULES:-$(sed -n 's/^THAW_VIEW_MODULES:PATH=//p' "$build/CMakeCache.txt")}
skipped=() readers=0

"$thaw" run "$source_dir/tests/export/scene.toml" --out "$work/run" >"$work/log" 2>&1
expectExit 0 "run"
export() { "$thaw" export "$work/run" "$@" >"$work/log" 2>&1; }

export --as ply; expectExit 0 "ply"
export --as ply --what obstacles; expectExit 0 "ply of obstacles"
[ "$(find "$work/run/export" -name 'scene_obstacles_00000[0-4].ply' | wc -l)" = 5 ] ||
  fail "names of files of obstacles"
rm "$work"/run/export/*_obstacles_*
export --as usd --what all --out "$work/run.usdc"; expectExit 0 "usd"
grep -q '^5 frames as usd, about ' "$work/log" || fail "no announcement of the size"
export --as usda --what all --out "$work/run.usda"; expectExit 0 "usda"
export --as usd --what all --threads 1 --out "$work/one.usdc"; expectExit 0 "usd on one thread"
cmp -s "$work/run.usdc" "$work/one.usdc" || fail "the layer depends on the number of threads"
left=$(find "$work" -name '*.part' -o -name '*.sample')
[ -z "$left" ] || fail "left $left"

# --resume keeps complete files, and writes missing or outdated ones
sums() { (cd "$work/run/export" && ls -l --time-style=full-iso ./*.ply); }
before=$(sums)
export --as ply --resume; expectExit 0 "resume"
grep -q '^5 complete files are kept' "$work/log" || fail "complete files are not reported"
[ "$before" = "$(sums)" ] || fail "complete files are written again"
rm "$work/run/export/scene_surface_000003.ply"
touch "$work/run/frames/scene_surface_000001.hdf"
export --as ply --resume; expectExit 0 "resume without one file"
grep -q '^3 complete files are kept' "$work/log" || fail "old or missing files are kept"
export --as usd --what all --out "$work/run.usdc" --resume; expectExit 0 "resume of an old layer"
grep -q "is complete and kept" "$work/log" && fail "an old layer is kept"
export --as usd --what all --out "$work/run.usdc" --resume; expectExit 0 "resume of a layer"
grep -q "is complete and kept" "$work/log" || fail "a complete layer is written again"

if command -v node >/dev/null && [ -d "$MODULES/tinyusdz" ]; then
  node "$source_dir/tests/export/read_usd.mjs" "$MODULES" "$work/run.usdc" "$work/run.usda" \
    "$work"/run/export/*_surface_*.ply >"$work/log" 2>&1
  expectExit 0 "three.js and tinyusdz"
  readers=$((readers + 1))
else
  skipped+=("three.js and tinyusdz are not in $MODULES (scripts/view --test installs them)")
fi

export --as vdb --what all --out "$work/vdb"
if [ $? -eq 2 ] && grep -q "is built without OpenVDB" "$work/log"; then
  skipped+=("OpenVDB (libopenvdb-dev)")
elif ! /usr/bin/python3 -c 'import pyopenvdb' 2>/dev/null; then
  skipped+=("OpenVDB's module for Python (python3-openvdb)")
else
  # a ball of a radius of 5 cm
  /usr/bin/python3 "$source_dir/tests/export/read_vdb.py" "$work/vdb/scene_all_000000.vdb" 5.236e-4 \
    >"$work/log" 2>&1
  expectExit 0 "OpenVDB"
  readers=$((readers + 1))
fi

export --as vtkhdf --what all --out "$work/run.vtkhdf"; expectExit 0 "vtkhdf"
if /usr/bin/python3 -c 'import h5py, numpy' 2>/dev/null; then
  /usr/bin/python3 "$source_dir/tests/export/read_vtkhdf.py" "$work/run.vtkhdf" 5.236e-4 >"$work/log" 2>&1
  expectExit 0 "the VTKHDF file"
  readers=$((readers + 1))
else
  skipped+=("h5py and numpy (python3-h5py)")
fi

export --as bgeo --what particles; expectExit 0 "bgeo"
export --as bgeo --what surface; expectExit 0 "bgeo of a surface"
if ! command -v partconvert >/dev/null; then
  skipped+=("Partio's partconvert (no package of Debian)")
elif /usr/bin/python3 -c 'import h5py, numpy' 2>/dev/null; then
  partconvert "$work/run/export/scene_000002.bgeo" "$work/particles.pda" >"$work/log" 2>&1 &&
    /usr/bin/python3 "$source_dir/tests/export/read_bgeo.py" "$work/particles.pda" \
      "$work/run/frames/scene_000002.hdf" >>"$work/log" 2>&1
  expectExit 0 "Partio"
  partconvert "$work/run/export/scene_surface_000002.bgeo" "$work/surface.pda" >"$work/log" 2>&1
  expectExit 0 "Partio and a surface"
  readers=$((readers + 1))
fi

# a frame with obstacles, in three formats
frame=$work/run/frames/scene_surface_000002.hdf
for as in vtp ply obj; do
  "$thaw" export "$frame" --as $as --what surface,obstacles --out "$work/all.$as" >"$work/log" 2>&1
  expectExit 0 "$as of surface and obstacles"
done
"$thaw" export "$frame" --as vtp --mesh --out "$work/mesh.vtp" >"$work/log" 2>&1
expectExit 0 "vtp of a closed mesh"
grep -aq 'NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="[1-9]' "$work/mesh.vtp" ||
  fail "vtp --mesh has no triangles"
"$thaw" export "$frame" --as ply --mesh --out "$work/none.ply" >"$work/log" 2>&1; expectExit 2 "ply --mesh"
if command -v pvpython >/dev/null; then
  pvpython "$source_dir/tests/export/read_paraview.py" "$work/all.vtp" "$work/all.ply" "$work/all.obj" \
    >"$work/log" 2>&1
  expectExit 0 "ParaView"
  expectMessage 'ParaView reads all files' "ParaView"
  readers=$((readers + 1))
else
  skipped+=("ParaView (paraview, python3-paraview)")
fi
"$thaw" export "$frame" --as obj --out "$work/ball.obj" >"$work/log" 2>&1; expectExit 0 "obj"
if command -v blender >/dev/null; then
  volumes=()
  if [ -e "$work/vdb/scene_all_000002.vdb" ]; then volumes=("$work/vdb/scene_all_000002.vdb"); fi
  timeout 300 blender --background --factory-startup --python-exit-code 1 --python \
    "$source_dir/tests/export/read_blender.py" -- "$work/run/export/scene_surface_000002.ply" \
    "$work/ball.obj" "${volumes[@]}" >"$work/log" 2>&1
  expectExit 0 "Blender"
  expectMessage 'Blender reads all files' "Blender"
  readers=$((readers + 1))
else
  skipped+=("Blender (blender)")
fi

# the announced size is right within a factor of 1.5
announced() {  # announced NAME BYTES: of "5 frames as usd, about 1.2 MB and 3 s" in $work/log
  awk -v real="$2" '/ frames as .*, about / { split($0, part, "about "); split(part[2], word, " ")
    bytes = word[1] * (word[2] == "GB" ? 1e9 : 1e6); found = 1
    if (bytes < real / 1.5 || bytes > real * 1.5) exit 1 }
    END { if (!found) exit 1 }' "$work/log" || fail "$1: announced size ($2 bytes): $(head -n 1 "$work/log")"
}
for as in usd usda vtkhdf; do
  export --as $as --out "$work/size.$as"; expectExit 0 "size of $as"
  announced $as "$(stat -c %s "$work/size.$as")"
  grep -q '^[1-4] of 5 frames, left ' "$work/log" || fail "$as: no lines of progress"
done
export --as ply --out "$work/size"; expectExit 0 "size of ply"
announced ply "$(cat "$work"/size/*.ply | wc -c)"
# in a terminal a bar is redrawn in place
if command -v script >/dev/null; then
  TERM=xterm script -qec "'$thaw' export '$work/run' --as usd --out '$work/bar.usd'" /dev/null \
    >"$work/log" 2>&1
  tr '\r' '\n' <"$work/log" | grep -q '^\[=*>* *\]  *[0-9]* %  left .*  [1-5] of 5 frames' ||
    fail "no bar in a terminal: $(cat -v "$work/log")"
fi

for line in "${skipped[@]}"; do echo "skipped: $line"; done
[ "$readers" -gt 0 ] || [ "$failures" -gt 0 ] || exit 77
finish
