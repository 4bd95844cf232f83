#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The Blender add-on in headless Blender: it imports a run, renders a small frame with motion blur, and writes
# a scene that thaw accepts. Its readers agree with h5py. PICTURES=FOLDER keeps the pictures.
. "$(dirname "$0")/../support/run.sh"
python=$(command -v /usr/bin/python3 || command -v python3)
settings melt
launch 1 run "$scenes/melt.toml" "${set[@]}" --set end=0.2 --out "$work/melt" >"$work/log" 2>&1
expectExit 0 "melt"
bash "$source_dir/blender/zip.sh" "$work/thaw_io.zip" >"$work/log" 2>&1; expectExit 0 "the zip file"

if "$python" -c 'import h5py, numpy' 2>/dev/null; then
  PYTHONDONTWRITEBYTECODE=1 "$python" "$source_dir/tests/blender/readers_check.py" \
    "$work"/melt/frames/*.hdf >"$work/log" 2>&1
  expectExit 0 "the reader of frames"
fi
blender=$(command -v blender)
if [ -z "$blender" ]; then
  [ "$failures" -eq 0 ] || finish
  echo "the rest is skipped: blender is not installed"
  exit 77
fi
mkdir -p "$work/scripts/addons" "$work/pictures"
BLENDER_USER_SCRIPTS=$work/scripts BLENDER_USER_CONFIG=$work/config THAW_PROGRAM=$thaw timeout 600 \
  "$blender" --background --factory-startup --python-exit-code 1 --python \
  "$source_dir/tests/blender/blender_check.py" -- "$work/thaw_io.zip" "$work/melt" "$work/pictures" \
  >"$work/log" 2>&1
expectExit 0 "the add-on"
expectMessage 'add-on: all passed' "the add-on"
[ -z "${PICTURES:-}" ] || cp -r "$work/pictures/." "$PICTURES"
"$thaw" run "$work/pictures/made.toml" --steps 2 --out "$work/made" >"$work/log" 2>&1
expectExit 0 "the written scene runs"
grep -qx 'colour = "#ff0000"' "$work/pictures/made.toml" || fail "the colour of the material"
"$thaw" check "$work/pictures/made.toml" --json >"$work/log" 2>&1; expectExit 0 "check of the written scene"
"$python" - "$work/log" <<'PYTHON' || fail "the written scene: $(cat "$work/log")"
import json, sys
[body] = json.load(open(sys.argv[1]))['particles']['bodies']
assert body['name'] == 'cube' and abs(body['shape_mass'] - 900 * 0.2 * 0.1 * 0.1) < 0.01, body
PYTHON
finish
