#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# `thaw new`: each kind runs without a warning of the scene, has comments, and no file is overwritten.
. "$(dirname "$0")/../support/run.sh"
cd "$work" || exit 1
for kind in melt drop dam sheet oriented; do
  "$thaw" new "$kind" --kind "$kind" >"$work/log" 2>&1; expectExit 0 "new --kind $kind"
  expectMessage "thaw run $kind.toml" "the next command"
  [ "$(grep -c '#' "$kind.toml")" -ge 8 ] || fail "$kind.toml has few comments"
  "$thaw" run "$kind.toml" --steps 2 >"$work/log" 2>&1; expectExit 0 "run $kind.toml"
  grep warning "$work/log" && fail "$kind.toml: a warning"
done
# more updates of the surface would take longer than the rest of the run
"$thaw" check melt.toml >"$work/log" 2>&1; expectExit 0 "check melt.toml"
expectMessage "about 51 updates until the end, 51 of them at frames" "updates of the surface"
"$thaw" new 'a "name".toml' >"$work/log" 2>&1; expectExit 0 "a name with quotes"
"$thaw" run 'a "name".toml' --steps 1 --out quoted >"$work/log" 2>&1; expectExit 0 "a title with quotes"

sha256sum melt.toml >sum
"$thaw" new melt >"$work/log" 2>&1; expectExit 3 "a file that exists"
expectMessage '^thaw new: error: .*melt.toml: already exists, and is not overwritten: choose another name' \
  "the file that exists"
sha256sum -c --quiet sum || fail "melt.toml is overwritten"
"$thaw" new other --kind lava >"$work/log" 2>&1; expectExit 2 "an unknown kind"
expectMessage 'melt' "the known kinds"
"$thaw" new none/scene >"$work/log" 2>&1; expectExit 3 "a missing folder"
expectMessage 'none/scene.toml: ' "the missing folder"
"$thaw" new folder/ >"$work/log" 2>&1; expectExit 3 "a folder for a name"

mkdir schema && cd schema || exit 1
"$thaw" new one --schema >"$work/log" 2>&1; expectExit 0 "new --schema"
"$thaw" new two --schema >"$work/log" 2>&1; expectExit 0 "new --schema next to a schema"
cmp -s scene.schema.json "$scenes/scene.schema.json" || fail "the schema next to the scene"
head -n 1 two.toml | grep -qx '#:schema ./scene.schema.json' || fail "the scene does not name the schema"
finish
