#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# scripts/lint finds each kind of fault and names its place. Every fault is planted in a small tree.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
# shellcheck source=../../scripts/lib.sh
source "$root/scripts/lib.sh"
mapfile -t missing < <(missingPackages "${lint_packages[@]}")
if [ ${#missing[@]} -gt 0 ]; then
  say "skipped: ${missing[*]} not installed (scripts/lint installs them)"
  exit 77
fi
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
failures=0

licence='SPDX-License-Identifier: Apache-2.0'

# A tree of few files without findings.
plantTree() {
  rm -rf "$dir/tree"
  mkdir -p "$dir/tree/core/math" "$dir/tree/core/heat" "$dir/tree/docs" "$dir/tree/scripts"
  cp "$root"/.clang-format "$dir/tree/"
  cp "$root"/core/include_order.txt "$dir/tree/core/"
  printf '# Contributing\n' >"$dir/tree/CONTRIBUTING.md"
  cp "$root"/scripts/{lint,lib.sh,lint_{checks,files,fix,includes,names,prose}.py,lint_words.txt} \
    "$dir/tree/scripts/"
  printf '# Bibliography\n\n| key | reference |\n|---|---|\n| K05 | Keiser, Adams 2005. A paper |\n' \
    >"$dir/tree/docs/bibliography.md"
  printf '# Page\n## A part\nSee [the part](#a-part) and [the script](../scripts/lint).\n' \
    >"$dir/tree/docs/page.md"
  {
    printf '// %s\n// Squares (docs/page.md).\n#pragma once\n\n' "$licence"
    printf 'inline double square(double x) { return x * x; }\n'
  } >"$dir/tree/core/math/square.hpp"
  printf '// %s\n#include "core/math/square.hpp"\n\ndouble heat(double x) { return square(x); }\n' \
    "$licence" >"$dir/tree/core/heat/heat.cpp"
}

# Runs scripts/lint in the tree; sets its exit code and output.
lint() {
  code=0
  output=$("$dir/tree/scripts/lint" --no-tidy 2>&1) || code=$?
}

# finds NAME PATTERN: the last run has failed, with a line that matches the pattern.
finds() {
  if [ "$code" -ne 0 ] && grep -qE "$2" <<<"$output"; then return; fi
  printf 'FAILED: %s: exit code %s, expected 1 and a line like %s, got:\n%s\n' "$1" "$code" "$2" "$output"
  failures=$((failures + 1))
}

passes() {
  lint
  if [ "$code" -eq 0 ]; then return; fi
  printf 'FAILED: %s: expected no finding, got:\n%s\n' "$1" "$output"
  failures=$((failures + 1))
}

long='a line that has more columns than are allowed, in a script, which is not wrapped by any program'
long+=', ever, at all'
square=core/math/square.hpp

# Plants an upward include and an old name in headers of other forms, links by label and in HTML, words that
# the glossary has replaced, and long lines outside of sources.
plantHidden() {
  printf '// %s\n#pragma once\n#include <core/walls/wall.hpp>\n#  include "core/walls/wall.hpp"\n' \
    "$licence" >"$dir/tree/core/math/angle.hpp"
  printf '// %s\n#pragma once\n#include "core/walls/wall.hpp"\n' "$licence" >"$dir/tree/core/math/old.h"
  printf '// %s\n// The rank sends %s to it.\nint %s();\nconst char* text = "it is a %s";\n' \
    "$licence" home "take""Stock" "cham""pion" >"$dir/tree/core/heat/words.cpp"
  printf '\nSee [one][lost], [two][] and [three][known].\n\n[lost]: nothere.md\n[known]: page.md\n' \
    >"$dir/tree/docs/links.md"
  printf '<a href="gone.html">gone</a> <img src="gone.png">\n`[x][y]` is code.\n' >>"$dir/tree/docs/links.md"
  { printf '# Readme\n\nA sentence'; printf ' and on%.0s' {1..15}; printf '.\n'; } >"$dir/tree/README.md"
  printf '# %s\nRUN echo %s\n' "$licence" "$long" >"$dir/tree/Containerfile"
  printf '# %s\n' "$long" >"$dir/tree/scripts/config.cmake.in"
}

# begins FILE LINE...: the file begins with these lines
begins() {
  local file=$1
  shift
  if diff <(printf '%s\n' "$@") <(head -n "$#" "$dir/tree/$file"); then return; fi
  printf 'FAILED: the first lines of %s\n' "$file"
  failures=$((failures + 1))
}

plantTree
passes 'a tree without findings'

# Files without an SPDX line, which --fix adds: below "#!", and only where it is missing.
plantTree
sed -i 1d "$dir/tree/$square"
printf '#!/bin/sh\necho\n' >"$dir/tree/scripts/say"
printf 'project(tree)\n' >"$dir/tree/CMakeLists.txt"
printf 'name: ci\n' >"$dir/tree/scripts/ci.yml"
lint
finds 'a header without an SPDX line' "^$square:1: no line \"// $licence\" at the top"
finds 'a script without an SPDX line' "^scripts/say:1: no line \"# $licence\" at the top"
finds 'a CMake list without an SPDX line' '^CMakeLists.txt:1: no line'
finds 'a recipe without an SPDX line' '^scripts/ci.yml:1: no line'
"$dir/tree/scripts/lint" --fix
passes 'SPDX lines that --fix has added'
begins "$square" "// $licence" '// Squares (docs/page.md).'
begins scripts/say '#!/bin/sh' "# $licence" echo
begins CMakeLists.txt "# $licence" 'project(tree)'
begins scripts/ci.yml "# $licence" 'name: ci'
"$dir/tree/scripts/lint" --fix
begins scripts/say '#!/bin/sh' "# $licence" echo
begins core/heat/heat.cpp "// $licence" "#include \"$square\""

# Faults of C++ and Python that --fix corrects, and a listed include against the order.
plantTree
sed -i '3a #include "core/walls/wall.hpp"' "$dir/tree/$square"
printf '\n// %s\n' "$long" >>"$dir/tree/$square"
printf '# %s\nx  = 1\n' "$licence" >"$dir/tree/scripts/one.py"
lint
finds 'an upward include' "^$square:4: includes core/walls/wall.hpp: core/walls is above core/math"
finds 'a long comment in C++' "^$square:[0-9]+:.* not formatted"
finds 'Python that is not formatted' '^scripts/one.py:1: not formatted'
"$dir/tree/scripts/lint" --fix
printf '1 %s core/walls/wall.hpp\n' "$square" >"$dir/tree/scripts/lint_known_includes.txt"
passes 'a long comment that --fix has wrapped, and a listed include'

# One fault of every other kind, each in a file of its own.
printf '// Squares (docs/lost.md).\n#pragma once\n' >"$dir/tree/$square"
printf '// Of a number.\n// .5 of it is a half.\n#pragma once\n' >"$dir/tree/core/math/half.hpp"
printf 'echo "%s"\n' "$long" >"$dir/tree/scripts/long.sh"
printf '\nIt occ%s twice.\n[A link](nowhere.md)\n[Another](page.md#another-part)\n' ured \
  >>"$dir/tree/docs/page.md"
# Faults that other forms of a link, an include or a file hide.
plantHidden
printf '\n<<<<<<%s HEAD\n' '<' >>"$dir/tree/scripts/long.sh"
{ printf '\nThe step is to%s its length.\n\nA sentence' ld; printf ' and on%.0s' {1..15}; printf '.\n'; } \
  >>"$dir/tree/docs/page.md"
{ printf 'void steps() {\n'; printf '  step();\n%.0s' {1..70}; printf '}\n'; } >"$dir/tree/core/heat/long.cpp"
for i in {1..31}; do printf '#pragma once\n' >"$dir/tree/core/math/file_$i.hpp"; done
printf 'notes\n' >"$dir/tree/notes.txt"
mkdir "$dir/tree/drafts"
printf 'draft\n' >"$dir/tree/drafts/draft.txt"
for _ in {1..4000}; do printf 'It is a short sentence. '; done >"$dir/tree/docs/wordy.md"
lint
finds 'a file at the top level' '^notes.txt:1: notes.txt does not belong to the top level'
finds 'a folder at the top level' '^drafts/draft.txt:1: drafts does not belong to the top level'
finds 'a manual of many words' '^docs:1: the manual has 200[0-9][0-9] words, at most 20000'
finds 'a listed include that is gone' '^scripts/lint_known_includes.txt:1: .*occurs 0 times'
finds 'a long line' '^scripts/long.sh:1: 11[0-9] columns, at most 110'
finds 'a marker of a merge' '^scripts/long.sh:3: a marker of a merge'
finds 'a misspelt word' '^(\./)?docs/page.md:5: occ''ured ==> occurred'
finds 'a dead link' '^docs/page.md:6: dead link: there is no docs/nowhere.md'
finds 'a word for persons' '^docs/page.md:9: "to''ld" makes a person of the code'
finds 'a long sentence' '^docs/page.md:11: a sentence of 32 words, at most 30'
finds 'a dead anchor' '^docs/page.md:7: dead link: docs/page.md has no heading #another-part'
finds 'a dead reference in a comment' "^$square:1: the comment names docs/lost.md"
finds 'a comment that begins with "of"' '^core/math/half.hpp:1: a comment begins with "Of"'
finds 'a decimal without its zero' '^core/math/half.hpp:2: a decimal without its leading zero'
finds 'an upward include in angle brackets' '^core/math/angle.hpp:3: includes core/walls/wall.hpp'
finds 'an upward include behind blanks' '^core/math/angle.hpp:4: includes core/walls/wall.hpp'
finds 'an upward include of another header' '^core/math/old.h:3: includes core/walls/wall.hpp'
finds 'a header of another ending' '^core/math/old.h:1: C\+\+ files end in .cpp or .hpp'
finds 'a retired word of a comment' '^core/heat/words.cpp:2: "sends ho''me" is retired: redistribute'
finds 'a retired name' '^core/heat/words.cpp:3: "take''Stock" is retired: initializeForces'
finds 'a retired word of a message' '^core/heat/words.cpp:4: "cham''pion" is retired: local maximum'
finds 'a dead definition of a label' '^docs/links.md:4: dead link: there is no docs/nothere.md'
finds 'a label without definition' '^docs/links.md:2: dead link: nothing defines \[two\]'
finds 'a dead link in HTML' '^docs/links.md:6: dead link: there is no docs/gone.html'
finds 'a picture that is not there' '^docs/links.md:6: dead link: there is no docs/gone.png'
finds 'a long sentence of the README' '^README.md:3: a sentence of 32 words, at most 30'
finds 'a long line of a recipe' '^Containerfile:2: 1[0-9]* columns, at most 110'
finds 'a long line of a template' '^scripts/config.cmake.in:1: 1[0-9]* columns, at most 110'
finds 'a long function' '^core/heat/long.cpp:1: steps has 72 lines, at most 70'
finds 'a full folder' '^core/math:1: 34 source files, at most 30'

# A circle of folders that entries for single files hide, and names that do not exist.
plantTree
printf '%s\n' core/math core/heat core/math/late.hpp tests >"$dir/tree/core/include_order.txt"
{
  printf '// %s\n// Late (K05): Late::now, Late::gone.\n#pragma once\n' "$licence"
  printf '#include "core/heat/early.hpp"\n\nstruct Late {\n  int now;\n};\n'
} >"$dir/tree/core/math/late.hpp"
{
  printf '// %s\n// Early (Q99), after Keiser et al. 2005.\n#pragma once\n' "$licence"
  printf '#include "core/math/square.hpp"\n'
} >"$dir/tree/core/heat/early.hpp"
mkdir "$dir/tree/tests"
{
  printf '// %s\n// Late.IsNow and Late.IsGone.\n\n' "$licence"
  printf 'TEST(Late, IsNow) {}\nTEST(Late, isSmall) {}\n'
} >"$dir/tree/tests/late_test.cpp"
printf 'After Keiser et al. 2005, Nobody 1999 and stability row 7.\n' >>"$dir/tree/docs/page.md"
lint
finds 'a circle of folders' '^core/math/late.hpp:4: core/math includes core/heat, which includes core/math'
finds 'an unknown key' '^core/heat/early.hpp:2: docs/bibliography.md has no key Q99'
finds 'an author in a comment' '^core/heat/early.hpp:2: cites "Keiser et al. 2005": name its key'
finds 'an unknown author' '^docs/page.md:4: docs/bibliography.md does not list "Nobody 1999"'
finds 'an unknown row' '^docs/page.md:4: docs/validation/stability.md has no row 7'
finds 'an unknown member' '^core/math/late.hpp:2: Late::gone does not exist'
finds 'an unknown test' '^tests/late_test.cpp:2: test Late.IsGone does not exist'
finds 'the style of a test' '^tests/late_test.cpp:5: test Late.isSmall: isSmall is not in CapitalisedWords'
if grep -E 'Late::now|Late.IsNow|K05|list "Keiser' <<<"$output"; then
  printf 'FAILED: names that exist are findings\n'
  failures=$((failures + 1))
fi

# clang-tidy of all sources checks those of a folder together, with the configuration of the tree.
plantTree
cp "$root"/scripts/lint_tidy.py "$dir/tree/scripts/"
printf 'Checks: "-*,readability-container-size-empty"\nHeaderFilterRegex: /core/\n' >"$dir/tree/.clang-tidy"
printf '#include <string>\nbool small(const std::string& s) { return s.size() == 0; }\n' \
  >"$dir/tree/core/heat/small.cpp"
mkdir "$dir/build"
for source in heat small; do
  path=$dir/tree/core/heat/$source.cpp
  printf '{"directory": "%s", "file": "%s", ' "$dir/tree" "$path"
  printf '"command": "g++ -mmove-max=256 -mmemset-strategy=libcall:-1:noalign -Werror -std=c++20 -I. '
  printf -- '-c %s"}\n' "$path"
done | python3 -c 'import json, sys; print(json.dumps([json.loads(line) for line in sys.stdin]))' \
  >"$dir/build/compile_commands.json"
code=0
output=$(python3 "$dir/tree/scripts/lint_tidy.py" "$dir/build" ALL 2>&1) || code=$?
finds 'a finding of clang-tidy in a group' 'core/heat/small.cpp:2:.*readability-container-size-empty'
sed -i 's/s.size() == 0/s.empty()/' "$dir/tree/core/heat/small.cpp"
python3 "$dir/tree/scripts/lint_tidy.py" "$dir/build" ALL || {
  printf 'FAILED: clang-tidy finds faults in a tree without them\n'
  failures=$((failures + 1))
}

[ "$failures" -eq 0 ] || { printf '%s checks failed\n' "$failures"; exit 1; }
