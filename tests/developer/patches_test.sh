#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The patches of examples/patches apply to the tree, change few files, and their sources compile.
. "$(dirname "$0")/../support/run.sh"
if ! command -v patch >/dev/null; then
  echo "skipped: patch is not installed"
  exit 77
fi
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
flags=(-std=c++20 -fsyntax-only -Wall -Wextra -Wno-psabi -Wno-maybe-uninitialized -Werror -DTHAW_ISA=isa_base)

# checkPatch NAME MOST SOURCE...: the patch changes at most MOST files; SOURCE: further sources to compile, in
# which the headers that it changes are used.
checkPatch() {
  local name=$1 most=$2 file=$source_dir/examples/patches/$1.patch tree=$work/$1 changed source
  shift 2
  mapfile -t changed < <(sed -n 's|^+++ b/\([^[:space:]]*\).*|\1|p' "$file")
  if [ "${#changed[@]}" -lt 1 ] || [ "${#changed[@]}" -gt "$most" ]; then
    fail "$name changes ${#changed[@]} files, expected 1 to $most: ${changed[*]}"
  fi
  mkdir "$tree"
  cp -r "$source_dir"/{core,io,parallel} "$tree/"
  if ! (cd "$tree" && patch -p1 --batch --forward --fuzz=0) <"$file" >"$work/log" 2>&1; then
    fail "$name does not apply; make it anew (docs/developer/extend.md)"
    cat "$work/log"
    return
  fi
  for source in "${changed[@]}" "$@"; do
    [[ $source = *.cpp ]] || continue
    (cd "$tree" && "$compiler" "${flags[@]}" -I "$tree" "$source") >"$work/log" 2>&1 ||
      { fail "$name: $source does not compile"; head -n 20 "$work/log"; }
  done
}

checkPatch pair_force 4 core/terms/extensions.cpp
checkPatch elastic_law 3 core/solid/laws/built_in_laws.cpp core/solid/elasticity/elastic_isa.cpp

# Each patch of the folder has a check above.
for file in "$source_dir"/examples/patches/*.patch; do
  grep -q "^checkPatch $(basename "$file" .patch) " "$0" || fail "$(basename "$file") has no check"
done

[ "$failures" -eq 0 ]
