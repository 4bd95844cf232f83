#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# ledger.csv has a row for the start, each frame, each output.ledger_every and the end. It has the same bytes
# on any number of ranks, after a kill and after retries, and does not change the run.
. "$(dirname "$0")/../support/run.sh"
cat >"$work/s.toml" <<'SCENE'
spacing = "2 cm"
end = "0.06 s"
[domain]
min = [-0.2, -0.2, -0.1]
max = [0.2, 0.2, 0.6]
sides = { x = "wall", y = "periodic", z = "open" }
[material.water]
viscosity = 0.01
surface_tension = 0.5
conductivity = 5
[material.jelly]
young = "20 kPa"
conductivity = 5
[[body]]
name = "pool"
box = { size = [0.4, 0.4, 0.1] }
place = { move = [0, 0, 0.05] }
material = "water"
[[body]]
name = "block"
box = { size = [0.1, 0.1, 0.1] }
place = { move = [0.02, 0, 0.17] }
material = "jelly"
velocity = [0.1, 0, -1]
temperature = 330
[[emitter]]
name = "jet"
material = "water"
disc = { radius = 0.04 }
centre = [-0.1, 0, 0.3]
[[obstacle]]
name = "floor"
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
temperature = 350
[[obstacle]]
name = "paddle"
box = { size = [0.05, 0.1, 0.2] }
place = { move = [0.15, -0.2, 0.25] }
temperature = 350
motion = [{ time = 0 }, { time = 1, move = [0, 0, 0.5] }]
[numerics]
tension = "surface energy"   # the form with a stored energy
[output]
every = "20 ms"
SCENE
run() {
  launch "$1" run "$work/s.toml" --set output.ledger_every=0.004 --out "$work/$2" "${@:3}" >"$work/log" 2>&1
}
same() {
  cmp -s "$work/$1/ledger.csv" "$work/$2/ledger.csv" || {
    fail "$3: ledger.csv differs"
    diff "$work/$1/ledger.csv" "$work/$2/ledger.csv" | head -n 4 | cut -c 1-300
  }
}
run 1 one; expectExit 0 "on one rank"
run 3 three; expectExit 0 "on three ranks"
same one three "three ranks"
"$thaw" compare --frames "$work/one" "$work/three" >"$work/log" 2>&1 || {
  fail "three ranks: other bits next to an obstacle with an image"
  cat "$work/log"
}

# entries of the ledger
awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; n = NF; next }
  NF != n { print "row " NR ": " NF " fields"; bad = 1 }
  {
    t = $at["time_s"]
    if (NR > 2 && (t <= last || t - last > 0.006)) { print "time " t " after " last; bad = 1 }
    last = t
    rows++
  }
  {
    sum = $at["gravity_J"] + $at["compression_J"] + $at["surface_tension_J"] + $at["contact_J"]
    scale += $at["kinetic_J"]
    if ((sum - $at["potential_J"]) ^ 2 > 1e-18 * $at["potential_J"] ^ 2) {
      print "potential " $at["potential_J"] " of parts " sum
      bad = 1
    }
  }
  { for (k in most) { v = $at[k]; if (v < 0) v = -v; if (v > most[k]) most[k] = v } }
  BEGIN {
    split("elastic_J compression_J surface_tension_J dissipated_J wall_work_J heat_in_J entered_mass_kg " \
      "entered_kinetic_J wall_impulse_z_N_s", names, " ")
    for (k in names) most[names[k]] = 0
  }
  END {
    for (k in most) if (most[k] == 0) { print k " is always 0"; bad = 1 }
    if (rows < 16 || last != 0.06) { print rows " rows to " last; bad = 1 }
    exit bad
  }' "$work/one/ledger.csv" ||
  fail "what ledger.csv holds"
for time in 0 0.02 0.04 0.06; do
  cut -d, -f2 "$work/one/ledger.csv" | grep -qx "$time" || fail "no row of the frame at $time s"
done

# without output.ledger_every: the rows of frames, and the same bits
launch 2 run "$work/s.toml" --out "$work/frames" >"$work/log" 2>&1; expectExit 0 "without ledger_every"
[ "$(wc -l <"$work/frames/ledger.csv")" = 5 ] ||
  fail "$(wc -l <"$work/frames/ledger.csv") lines for four frames"
"$thaw" compare "$work/one" "$work/frames" >"$work/log" 2>&1 || {
  fail "ledger_every changes the run"
  cat "$work/log"
}

# killed and resumed on another number of ranks, with an incomplete line; then with the log of another version
run 2 parts --steps 20; expectExit 0 "first part"
launchInBackground 3 run "$work/s.toml" --set output.ledger_every=0.004 --set output.checkpoint=0.05 \
  --resume --out "$work/parts" >"$work/log" 2>&1
sleep 1
killAll -9 "$work/parts"
printf '%s' "9999,0.1" >>"$work/parts/ledger.csv"
run 2 parts --resume; expectExit 0 "resumed"
same one parts "after a kill"
run 1 later --steps 20; expectExit 0 "first part"
echo "step,time_s" >"$work/later/ledger.csv"
run 1 later --resume; expectExit 0 "with a log of other columns"
[ "$(head -n 1 "$work/later/ledger.csv")" = "$(head -n 1 "$work/one/ledger.csv")" ] ||
  fail "the head of a log of other columns"
[ "$(tail -n 1 "$work/later/ledger.csv")" = "$(tail -n 1 "$work/one/ledger.csv")" ] ||
  fail "the last row after a log of other columns"

# The mechanical energies of a heated liquid at rest are rounding relative to its heat.
cat >"$work/heat.toml" <<'SCENE'
spacing = 0.01
end = 0.2
[domain]
min = [-0.1, -0.1, -0.1]
max = [0.3, 0.1, 0.1]
gravity = [0, 0, 0]
[material.wax]
sound_speed = 30
young = 1e5
viscosity = 1e-3
conductivity = 50
heat_capacity = 1000
latent_heat = 1e4
melts = 350
[[body]]
material = "wax"
box = { size = [0.1, 0.06, 0.06] }
place = { move = [0.05, 0, 0] }
temperature = 349
[[obstacle]]
name = "hot"
box = { size = [0.02, 0.2, 0.2] }
place = { move = [-0.01, 0, 0] }
temperature = 400
SCENE
launch 1 run "$work/heat.toml" --out "$work/heat" >"$work/log" 2>&1; expectExit 0 "a heated liquid"
expectMessage '^t 0.20000 .*residual .* J (rounding)' "the residual of a run of heat"
grep -q 'ledger does not close' "$work/log" && fail "a run of heat whose ledger does not close"

# repeated stretches leave no rows
settings beam
set+=(--set end=0.05 --set output.every=0.01 --set output.ledger_every=0.001 --set numerics.fixed_step=6e-4)
for ranks in 1 3; do
  launch "$ranks" run "$scenes/beam.toml" "${set[@]}" --out "$work/beam.$ranks" >"$work/log" 2>&1
  expectExit 0 "with a retry on $ranks"
  [ "$(value "$work/beam.$ranks/summary.json" retries)" -ge 1 ] || fail "no retry on $ranks ranks"
done
same beam.1 beam.3 "with retries"
awk -F, 'NR > 2 && $1 <= last { print "step " $1 " after " last; bad = 1 }
  { last = $1 }
  END { exit bad }' "$work/beam.1/ledger.csv" || fail "rows of stretches that failed"
finish
