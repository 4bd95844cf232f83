#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Coefficients that change at a restart. The change is reported, and the jump of stored energy is an entry of
# the ledger, not a failure, the same on any number of ranks. A change that is impossible is refused; a change
# without effect is reported as such. thaw compare works on runs with all body types.
. "$(dirname "$0")/../support/run.sh"
. "$(dirname "$0")/../support/contact_scene.sh"
{ contactScene; clothOver; } >"$work/all.toml"
options=(--set 'body.block.velocity=[0, 0, -0.4]' --set numerics.retry_every=20)
# begins FOLDER
begins() {
  launch 2 run "$work/all.toml" "${options[@]}" --steps 500 --out "$1" >"$work/log" 2>&1
  expectExit 0 "first part"
}
begins "$work/first"
for change in oriented.net.stiffness=150 sheet.cloth.warp=2000 material.jelly.young=6e3 \
  oriented.net.attract=0.1; do
  for ranks in 1 3; do
    rm -rf "$work/run.$ranks"
    cp -r "$work/first" "$work/run.$ranks"
    launch $ranks run "$work/all.toml" "${options[@]}" --set "$change" --steps 800 --restart \
      --out "$work/run.$ranks" >"$work/log" 2>&1
    expectExit 0 "$change on $ranks ranks"
    expectMessage "^warning: changed at the restart: ${change%%=*}" "$change"
    grep -q 'back to step' "$work/log" && fail "$change: treated as a failure"
  done
  same "$work/run.1" "$work/run.3" "$change on 1 and 3 ranks"
  jump=$(value "$work/run.1/summary.json" restart_jump_J)
  residual=$(value "$work/run.1/summary.json" mechanical_energy_J)
  awk -v j="$jump" -v r="$residual" 'BEGIN { exit !(j * j > 1e-12 && r * r < 0.01 * j * j) }' ||
    fail "$change: residual $residual J with a jump of $jump J"
  echo "$change: jump $jump J, residual $residual J"
done
"$thaw" compare "$work/run.1" "$work/run.3" >"$work/log" 2>&1; expectExit 0 "compare of a run with all types"
expectMessage '^equal: 125 particles, [0-9]* oriented, 256 sheet, [0-9]* fields' \
  "compare of a run with all types"
"$thaw" compare "$work/run.1" "$work/first" >"$work/log" 2>&1; expectExit 1 "compare of different runs"
expectMessage '^oriented position: [0-9]* of [0-9]* ids differ' "compare of different runs"
expectMessage '^sheet position: 256 of 256 ids differ' "compare of different runs"
"$thaw" export "$work/run.1" --what sheet --as ply --field nonsense --out "$work/export" >"$work/log" 2>&1
expectExit 2 "export with a field"
expectMessage 'expected no --field, got nonsense' "export with a field"
for change in 'body.block.box.size=[0.2,0.1,0.1]' oriented.net.patch.width=0.6 oriented.net.thin=0.5 \
  oriented.net.density=2 sheet.cloth.mass=1; do
  launch 2 run "$work/all.toml" "${options[@]}" --set "$change" --restart --out "$work/first" \
    >"$work/log" 2>&1
  expectExit 2 "$change"
  expectMessage 'cannot continue with this scene' "$change"
done
for change in oriented.net.relax=50 oriented.net.jitter=0.1 'sheet.cloth.velocity=[0,0,1]'; do
  rm -rf "$work/run.1"
  cp -r "$work/first" "$work/run.1"
  launch 2 run "$work/all.toml" "${options[@]}" --set "$change" --steps 510 --restart --out "$work/run.1" \
    >"$work/log" 2>&1
  expectExit 0 "$change"
  expectMessage '^warning: changed at the restart, without effect' "$change"
done
finish
