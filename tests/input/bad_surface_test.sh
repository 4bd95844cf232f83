#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Implausible surface settings give a warning, impossible ones an error.
. "$(dirname "$0")/../support/bad_input.sh"

drop="[material.oil]
[[body]]
material = 'oil'
sphere = { radius = 0.15 }
[surface]"
surfaceKey() {
  local file=surface_$1_${2/./_}
  warns "surface.$1 = $2" "$file.toml:11:[0-9]+: surface.$3.* recommended" "$file" "$drop
$1 = $2"
}
surfaceKey spacing 0.12 "spacing .0.12 m. is above spacing"
surfaceKey support 12 "support is 12: about 520 surfels"
surfaceKey support 1.5 "support is 1.5: about 8 surfels"
surfaceKey particle_support 3 "particle_support is 3: about 452 particles"
surfaceKey every_move 5 "every_move is 5"
surfaceKey implicit 0 "implicit is 0"
surfaceKey attract 1 "attract is 1"
surfaceKey smooth 0 "smooth is 0"
surfaceKey repel 0 "repel is 0"
surfaceKey iso_level 0.7 "iso_level is 0.7"
surfaceKey damping 1e-9 "damping is 1e-09"
surfaceKey damping 2 "damping is 2"
surfaceKey iterations 1 "iterations is 1"
surfaceKey stop 1 "stop is 1"
surfaceKey adapt 0.001 "adapt is 0.001: 1000000 surfels"
surfaceKey enforce_volume 0.1 "enforce_volume is 0.1"
surfaceKey link_length 4 "link_length is 4"
rejects "a surface far within its particles" \
  "level.toml:11:[0-9]+: error: surface.iso_level.* between 0.2 and 0.8" \
  2 check "$(bodyTypes level <<<"$drop
iso_level = 0.95")"
rejects "a surface that feels particles far away" \
  "reach.toml:11:[0-9]+: error: surface.particle_support.* between 1 and 3" \
  2 check "$(bodyTypes reach <<<"$drop
particle_support = 4")"
allCases
