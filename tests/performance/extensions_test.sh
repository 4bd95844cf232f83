#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Instructions of steps with a part of an extension, over those with the same part of the library, counted by
# valgrind. A part may take 3 % more.
#
#   extensions_test.sh BUILD
build=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=count_instructions.sh
source "$here/count_instructions.sh"

failed=0
for part in law single_law pair_force force heat shape; do
  library=$(count extension_step "$part" built-in) || { code=$?; echo "$library"; exit "$code"; }
  extension=$(count extension_step "$part" extension) || { code=$?; echo "$extension"; exit "$code"; }
  printf '%s: %d instructions, %d in the library: %+.2f %%\n' "$part" "$extension" "$library" \
    "$(awk "BEGIN { print 100 * ($extension / $library - 1) }")"
  awk "BEGIN { exit !($extension > 1.03 * $library) }" && { echo "$part takes over 3 % more"; failed=1; }
done
exit "$failed"
