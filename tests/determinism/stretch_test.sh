#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A bar that hangs from a clamp and stretches to several times its length: bonded neighbours end up several
# cells, and ranks, apart. The same bits on 1, 2, 3, 4 and 7 ranks, and over a restart while it is long. A
# spinning block flies out of an open side: its particles stay on their ranks until a restart or a new
# partition.
. "$(dirname "$0")/../support/run.sh"
cat >"$work/bar.toml" <<'SCENE'
spacing = "2 cm"
end = "1 s"
[domain]
min = [-0.2, -0.2, -3]
max = [0.2, 0.2, 0.2]
[material.gum]
young = "1.5 kPa"
law = "corotated"
[[body]]
name = "bar"
box = { size = [0.06, 0.06, 0.3] }
material = "gum"
place = { move = [0, 0, -0.05] }
clamp = [{ box = { size = [0.1, 0.1, 0.05] }, place = { move = [0, 0, 0.1] } }]
[output]
every = "0.1 s"
SCENE
sameOnAllRanks bar 1000000 "40 80" "$work/bar.toml" --set end=0.5
# the bar weighs 1.08 kg and its middle starts at -0.05 m; it must sink by its own length and more
sunk=$(grep -o '"potential_J": [-0-9.e]*' "$work/bar.1/summary.json" | sed -n 2p |
  awk '{ print ($2 < -0.53 - 1.08 * 9.81 * 0.3) }')
[ "$sunk" = 1 ] || fail "the bar did not stretch: \
$(grep -o '"potential_J": [-0-9.e]*' "$work/bar.1/summary.json" | tr '\n' ' ')"
cat >"$work/flier.toml" <<'SCENE'
spacing = "2 cm"
end = "1 s"
[domain]
min = [-0.3, -0.3, -0.3]
max = [1.2, 0.3, 0.3]
gravity = [0, 0, 0]
[material.gum]
young = "40 kPa"
law = "corotated"
[[body]]
name = "flier"
box = { size = [0.16, 0.3, 0.08] }
material = "gum"
velocity = ["3 m/s", 0, 0]
spin = [0, 0, 8]
[output]
every = "0.1 s"
SCENE
sameOnAllRanks flier 1000000 "100 300" "$work/flier.toml" --set end=0.4
[ "$(value "$work/flier.1/summary.json" particles)" -lt 480 ] || fail "nothing left the domain"
finish
