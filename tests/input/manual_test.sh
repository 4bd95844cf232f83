#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every complete scene of the manual runs, and every page that README.md, code and tests name exists.
. "$(dirname "$0")/../support/run.sh"
mapfile -t pages < <(find "$source_dir/docs" -name '*.md' | sort)

# A complete scene is a toml block whose first line is "# NAME.toml".
awk -v folder="$work/" 'FNR == 1 { file = "" }
  /^```/ { file = "" }
  start && /^# [a-z_]+\.toml$/ { file = folder $2 }
  { start = /^```toml/ }
  file != "" { print > file }' "$source_dir/README.md" "${pages[@]}"
cd "$work" || exit 1
for scene in butter cast drops glass heat pat scan; do
  [ -f "$scene.toml" ] || fail "the manual has no scene $scene.toml"
done
"$thaw" run cast.toml >log 2>&1 &&
  "$thaw" export out/cast/frames/cast_surface_000000.hdf --as ply --out scan.ply >>log 2>&1 || {
  cat log
  fail "the mesh scan.ply"
}
cp "$source_dir/examples/film/film.toml" . # it melts the same mesh
for scene in *.toml; do
  "$thaw" run "$scene" --steps 2 >log 2>&1 || { cat log; fail "$scene"; }
done

cd "$source_dir" || exit 1
while read -r page; do
  [ -f "$page" ] || fail "$page is named, but does not exist"
# scripts/lint and its test name missing pages on purpose
done < <(grep -rhoE --exclude='lint_*' '\bdocs/[a-z_/]+\.md' README.md CONTRIBUTING.md core parallel io \
  tests benchmarks scripts scenes | sort -u)

[ "$failures" -eq 0 ]
