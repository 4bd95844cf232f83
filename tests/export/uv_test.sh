#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# `thaw export --uv`: texture coordinates follow a body that flies and melts. Its mesh has u = x and v = z.
. "$(dirname "$0")/../support/run.sh"
python=$(command -v /usr/bin/python3 || command -v python3)
if ! "$python" -c 'import numpy' 2>/dev/null; then
  echo "skipped: numpy is not installed"
  exit 77
fi
{
  for z in 0 1; do for y in 0 1; do for x in 0 1; do
    echo "v $x $y $z"; echo "vt $x $z"
  done; done; done
  for f in "1 3 4 2" "5 6 8 7" "1 2 6 5" "3 7 8 4" "1 5 7 3" "2 4 8 6"; do
    read -r a b c d <<<"$f"; echo "f $a/$a $b/$b $c/$c $d/$d"
  done
} >"$work/cube.obj"
cat >"$work/uv.toml" <<'TOML'
spacing = 0.02
end = 0.1
[domain]
min = [-0.5, -0.5, -0.5]
max = [0.5, 0.5, 0.5]
gravity = [0, 0, 0]
[material.wax]
density = 900
young = "100 kPa"
[[body]]
mesh = "cube.obj"
material = "wax"
velocity = [1, 0, 0]
place = { height = 0.2, bottom = [0, 0, -0.1] }
[surface]
[output]
every = 0.05
TOML
"$thaw" run "$work/uv.toml" --out "$work/run" >"$work/log" 2>&1; expectExit 0 "run"
export() { "$thaw" export "$work/run" "$@" >"$work/log" 2>&1; }
export --as ply --uv; expectExit 0 "ply"
PYTHONDONTWRITEBYTECODE=1 "$python" - "$source_dir/blender/thaw_io" "$work"/run/export/*.ply \
  >"$work/log" 2>&1 <<'PYTHON'
import sys

import numpy as np

sys.path.insert(0, sys.argv[1])
import ply

assert len(sys.argv) == 5
for k, path in enumerate(sys.argv[2:]):
    x, triangles, others = ply.read(path)
    u, v = (x[:, 0] - 0.05 * k) / 0.2 + 0.5, x[:, 2] / 0.2 + 0.5
    away = np.hypot(others['s'] - u, others['t'] - v)
    # in the texture, an edge of the mesh is about 0.05 long
    assert np.median(away) < 0.02 and away.max() < 0.1, (k, np.median(away), away.max())
PYTHON
expectExit 0 "texture coordinates of ply"
export --as obj --uv; expectExit 0 "obj"
grep -q '^vt ' "$work"/run/export/uv_surface_000001.obj || fail "obj has no texture coordinates"
grep -qE '^f [0-9]+/[0-9]+/[0-9]+ ' "$work"/run/export/uv_surface_000001.obj || fail "faces of obj"
export --as usda --uv --out "$work/run.usda"; expectExit 0 "usda"
grep -q 'texCoord2f\[\] primvars:st' "$work/run.usda" || fail "usda has no texture coordinates"
export --as usd --uv --out "$work/run.usdc"; expectExit 0 "usd"
MODULES=${MODULES:-$(sed -n 's/^THAW_VIEW_MODULES:PATH=//p' "$build/CMakeCache.txt")}
if command -v node >/dev/null && [ -d "$MODULES/three" ]; then
  node "$(dirname "$0")/read_usd_uv.mjs" "$MODULES" "$work/run.usdc" >"$work/log" 2>&1
  expectExit 0 "texture coordinates of usd"
fi
export --as bgeo --uv; expectExit 0 "bgeo"
export --as vtkhdf --uv --out "$work/run.vtkhdf"; expectExit 0 "vtkhdf"
reader=$(dirname "$0")/read_uv.py
"$python" "$reader" "$work"/run/export/*.bgeo >"$work/log" 2>&1; expectExit 0 "texture coordinates of bgeo"
if "$python" -c 'import h5py' 2>/dev/null; then
  "$python" "$reader" "$work/run.vtkhdf" >"$work/log" 2>&1; expectExit 0 "texture coordinates of vtkhdf"
fi
export --as vdb --uv; expectExit 2 "a format without texture coordinates"
expectMessage "expected --as ply, obj, vtp, usd, usda, vtkhdf or bgeo" "a format without texture coordinates"
rm "$work/cube.obj"
export --as ply --uv; expectExit 2 "without the mesh"
expectMessage 'cube.obj: no such file' "without the mesh"
finish
