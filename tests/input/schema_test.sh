#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The JSON schema of scene files: it is current, accepts every scene of the project, and refuses wrong keys
# and values. taplo, which editors use, agrees. It is that of viewer/package-lock.json (`scripts/view --test`
# installs it), or else the one on PATH. MODULES=DIR: node_modules with @taplo/cli.
. "$(dirname "$0")/../support/run.sh"
python=$(command -v /usr/bin/python3 || command -v python3)
MODULES=${MODULES:-$(sed -n 's/^THAW_VIEW_MODULES:PATH=//p' "$build/CMakeCache.txt")}
taplo=$(command -v "$MODULES/.bin/taplo" || command -v taplo)
schema=$scenes/scene.schema.json

"$thaw" docs --schema >"$work/scene.schema.json"; expectExit 0 "thaw docs --schema"
cmp -s "$work/scene.schema.json" "$schema" ||
  fail "it is out of date; write it with: thaw docs --schema > scenes/scene.schema.json"
mapfile -t files < <(find "$scenes" "$source_dir/benchmarks" "$source_dir/examples" -name '*.toml')
[ "${#files[@]}" -ge 70 ] || fail "only ${#files[@]} scenes"
for kind in melt drop dam sheet oriented; do
  "$thaw" new "$work/$kind" --kind "$kind" --schema >"$work/log" || fail "thaw new --kind $kind"
  files+=("$work/$kind.toml")
done
while read -r file; do
  fail "$file names no schema: expected #:schema and the path of scene.schema.json in its first line"
done < <(find "$scenes" "$source_dir/examples" -name '*.toml' -print0 | xargs -0 awk \
  'FNR == 1 && !/^#:schema (\.\.?\/)+(scenes\/)?scene\.schema\.json$/ { print FILENAME }')

# wrong NAME SED: a copy of a scene with an error
wrong() { sed "$2" "$work/melt.toml" >"$work/wrong_$1.toml"; }
wrong key 's/^viscosity /viscosty /'
wrong table 's/^\[surface\]/[surfaces]/'
wrong inner 's/radius = "5 cm"/radus = "5 cm"/'
wrong number 's/radius = "5 cm"/radius = "five"/'
wrong range 's/^young .*/young = -1/'
wrong type 's/^title .*/title = 3/'
wrong word 's/^conductivity .*/law = "elastic"/'
wrong count 's/^gravity .*/gravity = [0, -9.81]/'
# valid forms that the scenes do not use
cat >"$work/forms.toml" <<'SCENE'
include = ["melt.toml"]
[domain]
sides = { x = "wall", z = ["wall", "open"] }
[material.lava]
viscosity = [["900 degC", "1e4 Pa s"], [1500, 50]]
young = { solid = "1 MPa", liquid = 0 }
yield_strain = "never"
melts = "1200 K"
[body]
name = "single"
difference = [{ sphere = { radius = 1 } }, { union = [{ box = { size = [1, "20 cm", 1] } }] }]
material = "lava"
velocity = { x = "-y", y = "x" }
temperature = "300 + 20*z"
[extension.trap]
stiffness = 3
SCENE

if [ -n "$python" ] && "$python" -c 'import tomllib' 2>/dev/null; then
  checker=$source_dir/tests/input/check_schema.py
  "$python" "$checker" "$schema" "${files[@]}" "$work/forms.toml" >"$work/log" 2>&1
  expectExit 0 "check_schema.py"
  for file in "$work"/wrong_*.toml; do
    "$python" "$checker" "$schema" "$file" >"$work/log" 2>&1
    expectExit 1 "check_schema.py accepts ${file##*/}"
  done
fi
if [ -n "$taplo" ]; then
  # RUST_LOG: else it prints each file
  RUST_LOG=error "$taplo" lint "${files[@]}" "$work/forms.toml" --schema "file://$schema" >"$work/log" 2>&1
  expectExit 0 "taplo"
  for file in "$work"/wrong_{key,inner,range}.toml; do
    RUST_LOG=error "$taplo" lint "$file" >"$work/log" 2>&1
    expectExit 1 "taplo accepts ${file##*/}"
  done
else
  echo "skipped: taplo is not in $MODULES (scripts/view --test installs it)"
fi
finish
