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
export BLENDER_USER_CONFIG=$work/config
BLENDER_USER_SCRIPTS=$work/scripts THAW_PROGRAM=$thaw timeout 600 \
  "$blender" --background --factory-startup --python-exit-code 1 --python \
  "$source_dir/tests/blender/blender_check.py" -- "$work/thaw_io.zip" "$work/melt" "$work/pictures" \
  >"$work/log" 2>&1
expectExit 0 "the add-on"
expectMessage 'add-on: all passed' "the add-on"
expectMessage 'my wax melts, but its heat capacity is empty' "the export"
expectMessage 'my wax has a latent heat, but does not melt' "the export"

# A second process shows the frames: with --addons, or with the script of the file.
renderFilm() {  # renderFilm FOLDER ARGUMENTS: frames 1 and 3 of the saved file
  local folder=$1; shift
  timeout 200 "$blender" --background --factory-startup "$@" "$work/pictures/film.blend" \
    --render-output "$work/$folder/" --render-frame 1 --render-frame 3 >"$work/log" 2>&1
  expectExit 0 "the film with ${*:-no option}"
}
expectFrames() {  # expectFrames equal|different FOLDER
  "$blender" --background --factory-startup --python-exit-code 1 --python \
    "$source_dir/tests/blender/pictures_check.py" -- "$1" "$work/$2/0001.png" "$work/$2/0003.png" \
    >"$work/log" 2>&1
  expectExit 0 "the frames of $2 are $1"
}
mkdir "$work/none" "$work/none/addons"
export BLENDER_USER_SCRIPTS=$work/scripts
renderFilm addon --addons thaw_io; expectFrames different addon
renderFilm script --enable-autoexec; expectFrames different script
renderFilm neither --disable-autoexec
expectMessage "skipping 'enable_thaw_io.py'" "a film whose script may not run"
expectFrames equal neither
BLENDER_USER_SCRIPTS=$work/none renderFilm missing --enable-autoexec
expectMessage 'install and enable the add-on thaw_io' "a film without the add-on"

[ -z "${PICTURES:-}" ] || cp -r "$work/pictures/." "$PICTURES"
"$thaw" run "$work/pictures/made.toml" --steps 2 --out "$work/made" >"$work/log" 2>&1
expectExit 0 "the written scene runs"
for scene in melts solid; do
  "$thaw" check "$work/pictures/$scene.toml" >"$work/log" 2>&1; expectExit 0 "check of $scene.toml"
done
grep -qx 'colour = "#ff0000"' "$work/pictures/made.toml" || fail "the colour of the material"
"$thaw" check "$work/pictures/made.toml" --json >"$work/log" 2>&1; expectExit 0 "check of the written scene"
"$python" - "$work/log" <<'PYTHON' || fail "the written scene: $(cat "$work/log")"
import json, sys
[body] = json.load(open(sys.argv[1]))['particles']['bodies']
assert body['name'] == 'cube' and abs(body['shape_mass'] - 900 * 0.2 * 0.1 * 0.1) < 0.01, body
PYTHON
finish
