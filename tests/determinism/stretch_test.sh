#!/usr/bin/env bash
# A bar that hangs from a clamp and stretches to several times its length: bonded neighbours end up several cells, and ranks, apart. The same
# bits on 1, 2, 3, 4 and 7 ranks, and over a restart while it is long.
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
for ranks in 1 2 3 4 7; do
  launch $ranks run "$work/bar.toml" --set end=0.5 --out "$work/$ranks" >"$work/log" 2>&1
  expectExit 0 "$ranks ranks"
  [ "$ranks" = 1 ] || "$thaw" compare "$work/1" "$work/$ranks" >"$work/log" 2>&1 || { fail "1 and $ranks ranks differ"; cat "$work/log"; }
done
launch 3 run "$work/bar.toml" --set end=0.5 --steps 100 --out "$work/parts" >"$work/log" 2>&1; expectExit 0 "first part"
launch 2 run "$work/bar.toml" --set end=0.5 --restart --out "$work/parts" >"$work/log" 2>&1; expectExit 0 "second part"
"$thaw" compare "$work/1" "$work/parts" >"$work/log" 2>&1 || { fail "restart differs"; cat "$work/log"; }
# the bar weighs 1.08 kg and its middle was at -0.05 m: it is to have sunk by its own length, and more
sunk=$(grep -o '"potential_J": [-0-9.e]*' "$work/1/summary.json" | sed -n 2p | awk '{ print ($2 < -0.53 - 1.08 * 9.81 * 0.3) }')
[ "$sunk" = 1 ] || fail "the bar did not stretch: $(grep -o '"potential_J": [-0-9.e]*' "$work/1/summary.json" | tr '\n' ' ')"
finish
