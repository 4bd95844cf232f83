#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# `thaw export` as USD, OpenVDB and VTKHDF, read by three.js, tinyusdz, OpenVDB's Python module and h5py. It
# names readers that are not installed at its end. MODULES=DIR: node_modules with the readers of USD.
. "$(dirname "$0")/../support/run.sh"
MODULES=${MODULES:-$(sed -n 's/^THAW_VIEW_MODULES:PATH=//p' "$build/CMakeCache.txt")}
skipped=()

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
[ -z "$(find "$work" -name '*.part')" ] || fail "left $(find "$work" -name '*.part')"

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
else
  skipped+=("three.js and tinyusdz are not in $MODULES (scripts/view --test installs them)")
fi

export --as vdb --what all --out "$work/vdb"
if [ $? -eq 2 ] && grep -q "is built without OpenVDB" "$work/log"; then
  skipped+=("OpenVDB (libopenvdb-dev)")
elif ! /usr/bin/python3 -c 'import pyopenvdb' 2>/dev/null; then
  skipped+=("OpenVDB's module for Python (python3-openvdb)")
else
  # a ball of 5 cm, whose particles have 171 times the volume of their spacing cubed
  /usr/bin/python3 "$source_dir/tests/export/read_vdb.py" "$work/vdb/scene_all_000000.vdb" 5.77e-4 \
    >"$work/log" 2>&1
  expectExit 0 "OpenVDB"
fi

export --as vtkhdf --what all --out "$work/run.vtkhdf"; expectExit 0 "vtkhdf"
if /usr/bin/python3 -c 'import h5py, numpy' 2>/dev/null; then
  /usr/bin/python3 "$source_dir/tests/export/read_vtkhdf.py" "$work/run.vtkhdf" 5.77e-4 >"$work/log" 2>&1
  expectExit 0 "the VTKHDF file"
else
  skipped+=("h5py and numpy (python3-h5py)")
fi

for line in "${skipped[@]}"; do echo "skipped: $line"; done
finish
