#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A first start that is refused leaves its summary with the status "refused", and no empty folders. A scene
# with errors leaves nothing. `thaw render` names the commands for a scene.
. "$(dirname "$0")/../support/run.sh"
jellyBlock >"$work/block.toml"
cd "$work" || exit 1
outside=(--set 'body.block.place.move=[0, 0, 5]')
for ranks in 1 2; do
  launch $ranks run block.toml "${outside[@]}" --out first >"$work/log" 2>&1
  expectExit 2 "a body outside on $ranks ranks"
  [ "$(value first/summary.json status)" = refused ] || fail "status '$(value first/summary.json status)'"
  grep -q 'outside of the domain' first/summary.json || fail "summary.json has no reason"
  [ "$(ls -A first)" = summary.json ] || fail "the folder has more than the summary: $(ls -A first)"
  rm -r first
done
launch 2 run block.toml --set spacing=0 --out some/where >"$work/log" 2>&1
expectExit 2 "a scene with an error"
[ ! -e some ] || fail "a scene with an error leaves $(find some)"

mkdir own
launch 1 run block.toml --set spacing=0 --out own >"$work/log" 2>&1
[ -d own ] || fail "the user's own empty folder is removed"
launch 2 run block.toml --out own >"$work/log" 2>&1; expectExit 0 "a run after a refusal"
launch 2 run block.toml "${outside[@]}" --out own >"$work/log" 2>&1; expectExit 2 "a refusal after a run"
[ "$(value own/summary.json status)" = done ] || fail "the summary of the run is lost"
[ "$(value own/summary.refused.json status)" = refused ] || fail "no summary of the refusal"
launch 1 run block.toml --restart --out nothing >"$work/log" 2>&1; expectExit 2 "restart of nothing"
expectMessage 'there is none: leave out --restart, or use --resume' "restart of nothing"

"$thaw" render block.toml >"$work/log" 2>&1; expectExit 2 "a picture of a scene"
expectMessage \
  '^thaw render: error: block.toml is a scene; use `thaw preview block.toml`, or render its run out/block$' \
  "a picture of a scene"
finish
