#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Meshes of a splash have no slivers: 99.9 % of the triangles have no angle below 15 degrees, none below 5.
. "$(dirname "$0")/../support/run.sh"
python=$(command -v /usr/bin/python3 || command -v python3)
if ! "$python" -c 'import numpy' 2>/dev/null; then
  echo "skipped: numpy is not installed"
  exit 77
fi
cat >"$work/splash.toml" <<'TOML'
spacing = "4 cm"
end = "0.45 s"
[domain]
min = [0, 0, 0]
max = [1.2, 0.35, 1.2]
sides = { x = "wall", y = "wall", z = ["wall", "open"] }
[material.water]
density = "1000 kg/m^3"
viscosity = "0.02 Pa s"
sound_speed = "15 m/s"
[[body]]
box = { size = ["0.42 m", "0.315 m", "0.49 m"] }
material = "water"
place = { move = ["0.23 m", "0.175 m", "0.26 m"] }
[[obstacle]]
box = { size = ["8 cm", "10 cm", "30 cm"] }
place = { move = ["0.8 m", "0.17 m", "0.15 m"] }
[surface]
[output]
every = "0.15 s"
TOML
launch 2 run "$work/splash.toml" --out "$work/run" >"$work/log" 2>&1; expectExit 0 "run"
"$thaw" export "$work/run" --as ply --out "$work/meshes" >"$work/log" 2>&1; expectExit 0 "ply"
PYTHONDONTWRITEBYTECODE=1 "$python" "$(dirname "$0")/angles.py" "$work"/meshes/*.ply >"$work/log" 2>&1
expectExit 0 "angles"
cat "$work/log"
finish
