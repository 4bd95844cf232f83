#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# `thaw preview SCENE`: pictures of scenes of all kinds before they run, and clear messages.
. "$(dirname "$0")/../support/run.sh"
cd "$work" || exit 1
for scene in pour beam sheet/cloth oriented/weld; do
  "$thaw" preview "$scenes/$scene.toml" --width 320 --height 240 --out "$work/shown.png" >"$work/log" 2>&1
  expectExit 0 "preview of $scene"
  [ "$(stat -c %s "$work/shown.png")" -gt 3000 ] || fail "the picture of $scene is blank"
  mv "$work/shown.png" "$work/$(basename "$scene").png"
done
"$thaw" preview "$scenes/pour.toml" --set emitter.jug.disc.radius=0.03 --width 320 --height 240 \
  --out "$work/wide.png" >"$work/log" 2>&1
expectExit 0 "preview with --set"
cmp -s "$work/pour.png" "$work/wide.png" && fail "--set changes the picture"
"$thaw" preview "$scenes/pour.toml" --through --width 320 --height 240 \
  --out "$work/through.png" >"$work/log" 2>&1
expectExit 0 "preview through the scene's camera"
cmp -s "$work/pour.png" "$work/through.png" && fail "--through changes the picture"
"$thaw" preview "$scenes/beam.toml" --width 320 --height 240 >"$work/log" 2>&1
[ -f "$work/beam_preview.png" ] || fail "the picture has a default name"
[ -e "$work/out" ] && fail "a preview leaves no folder of a run"

# The lines of the camera are in the picture only with the camera itself.
if /usr/bin/python3 -c 'import matplotlib' 2>/dev/null; then
  orange() {  # orange X,Y,Z: pixels in the camera's colour, with the camera at this place
    "$thaw" preview "$scenes/pour.toml" --set "output.camera.from=[$1]" --width 320 --height 240 \
      --out "$work/camera.png" >"$work/log" 2>&1
    /usr/bin/python3 -c 'import sys; from matplotlib.image import imread
print((abs(255 * imread(sys.argv[1])[..., :3] - (217, 130, 43)).max(axis=2) < 8).sum())' "$work/camera.png"
  }
  [ "$(orange 0.05,-0.2,0.16)" -gt 30 ] || fail "a camera in the picture has no lines"
  [ "$(orange 3,-0.4,0.26)" -eq 0 ] || fail "lines of a camera that is not in the picture"
fi

"$thaw" preview "$work/none.toml" >"$work/log" 2>&1
expectExit 2 "a scene that is not there"
printf 'spacing = "wide"\n' >"$work/bad.toml"
"$thaw" preview "$work/bad.toml" >"$work/log" 2>&1
expectExit 2 "a scene with an error"
expectMessage "bad.toml:1:" "a scene with an error"
"$thaw" preview "$scenes/beam.toml" --out "$work/bad.toml/x.png" >"$work/log" 2>&1
expectExit 3 "a picture that cannot be written"
finish
