#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Solids that fall asleep and wake (core/sleep/) have the same bits on 1, 2, 3, 4 and 7 ranks. A stop that
# another number of ranks resumes does not change them. Blocks come to rest, one falls on another much later,
# and a wall moves up to the last.
. "$(dirname "$0")/../support/run.sh"
scene=sleepers
cat >"$work/sleepers.toml" <<'SCENE'
spacing = 0.1
end = 1.6
[domain]
min = [-1, -1, -0.5]
max = [6, 1, 6]
[material.rubber]
density = 1000
young = 3e5
damping = 300
restitution = 0.2
[[body]]
name = "near"
material = "rubber"
box = { size = [0.8, 0.8, 0.4] }
place = { move = [0, 0, 0.25] }
[[body]]
name = "late"
material = "rubber"
box = { size = [0.4, 0.4, 0.3] }
place = { move = [0, 0, 4.5] }
[[body]]
name = "far"
material = "rubber"
box = { size = [0.8, 0.8, 0.4] }
place = { move = [2.5, 0, 0.25] }
[[body]]
name = "pushed"
material = "rubber"
box = { size = [0.8, 0.8, 0.4] }
place = { move = [4.5, 0, 0.25] }
[[obstacle]]
name = "floor"
plane = { }
[[obstacle]]
name = "ram"
box = { size = [0.4, 1, 0.6] }
place = { move = [5.6, 0, 0.4] }
motion = [ { time = 1.0, move = [0, 0, 0] }, { time = 1.4, move = [-0.6, 0, 0] } ]
[numerics]
sleep_speed = 0.02
sleep_after = 0.02
[output]
every = 0.2
SCENE
same() { sameRuns "$1" "$2" "$3" "frames/$scene.hdf.series"; }
# stops during sleep, before and after the late block has landed
sameOnAllRanks $scene 1000000 "320 960 1280" "$work/sleepers.toml" --set numerics.retry_every=10
expectSleepers() {
  slept=$(value "$work/$scene.1/summary.json" asleep)
  [ "${slept:-0}" -gt 0 ] || fail "$scene: nothing sleeps at the end"
}
expectSleepers
grep -q 'sleeping 0 (awake: [0-9]* accelerate)' "$work/$scene.log.1" ||
  fail "$scene: no report at the start of why blocks are awake"
# A coefficient that changes at a restart wakes all blocks. Sleepers with old constraint forces would be
# pushed.
for ranks in 1 3; do
  cp -r "$work/$scene.1" "$work/changed.$ranks"
  launch $ranks run "$work/sleepers.toml" --set numerics.retry_every=10 --set end=1.8 \
    --set material.rubber.damping=301 --restart --out "$work/changed.$ranks" >"$work/log" 2>&1
  expectExit 0 "$scene with another damping on $ranks ranks"
  grep -q 'ledger does not close' "$work/log" && fail "$scene: with another damping the ledger does not close"
done
same "$work/changed.1" "$work/changed.3" "$scene with another damping on 1 and 3 ranks"
[ "$(value "$work/changed.1/summary.json" asleep)" -gt 0 ] ||
  fail "$scene: nothing sleeps again after the change"
# A rod leans on a ring: parts fall asleep while others creep. Bonds carry the creeping parts' stress two
# cells far into the sleeping ones. The constraint force there must not depend on the ranks that read it.
scene=leaning
cat >"$work/leaning.toml" <<'SCENE'
spacing = 0.02
end = 2.6
[domain]
min = [-0.5, -0.5, -0.1]
max = [0.5, 0.5, 0.7]
[material.soft]
density = 1100
young = 3e5
law = "neo-hookean"
damping = 200
restitution = 0.05
friction = 0.7
[material.hard]
density = 1300
young = 1e6
damping = 200
restitution = 0.05
friction = 0.4
[[body]]
name = "ring"
torus = { radius = 0.08, tube = 0.03 }
material = "soft"
place = { rotate_x = "30 deg", move = [0, 0, 0.15] }
[[body]]
name = "rod"
cylinder = { radius = 0.04, height = 0.24 }
material = "hard"
place = { rotate_y = "80 deg", move = [0, 0.03, 0.28] }
[[obstacle]]
name = "floor"
plane = { }
friction = 0.6
[numerics]
sleep_speed = 0.03
sleep_after = 0.05
[output]
every = 0.4
SCENE
sameOnAllRanks $scene 1000000 "8000 11600 12000" "$work/leaning.toml"
expectSleepers
residual=$(awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ /^momentum_residual/) of[k] = 1; next }
  { for (k in of) { a = $k < 0 ? -$k : $k; if (a > most) most = a } }
  END { print most + 0 }' "$work/$scene.1/progress.csv")
awk -v r="$residual" 'BEGIN { exit !(r < 1e-9) }' || fail "momentum residual of $residual kg m/s"
# Rows of a sleeping block change places while a liquid flows far from it.
scene=beside
cat >"$work/beside.toml" <<'SCENE'
spacing = 0.1
end = 0.8
[domain]
min = [-1, -1, -0.5]
max = [6, 1, 3]
[material.rubber]
density = 1000
young = 3e5
damping = 600
restitution = 0.2
[material.water]
density = 1000
phase = "liquid"
viscosity = 1
[[body]]
name = "asleep"
material = "rubber"
box = { size = [0.8, 0.8, 0.8] }
place = { move = [0, 0, 0.45] }
[[body]]
name = "flowing"
material = "water"
box = { size = [0.8, 1, 0.8] }
place = { move = [4.5, 0, 0.45] }
[[obstacle]]
name = "floor"
plane = { }
[numerics]
sleep_speed = 0.05
sleep_after = 0.02
[output]
every = 0.2
SCENE
sameOnAllRanks $scene 1000000 "200 400" "$work/beside.toml"
expectSleepers
finish
