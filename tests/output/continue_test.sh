#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The command that scripts/run prints to continue a stopped run has all options that changed the scene.
. "$(dirname "$0")/../support/run.sh"
says() {  # says EXPECTED RANKS OPTIONS...
  local expected=$1 got
  shift
  got=$(bash -c '. "$0"; cores() { echo 4; }; optionsToContinue "$@"' "$source_dir/scripts/lib.sh" "$@") ||
    fail "exit code $? for $*"
  [ "$got" = "$expected" ] || fail "of '$*' it says '$got', not '$expected'"
}
says "" 4
says "" 4 --time-limit 60 --resume
says " --ranks 2" 2 --steps=5
says " --set surface.spacing=0.014 --set spacing=\\\"60\\ mm\\\"" 4 --time-limit 1 --force \
  --set surface.spacing=0.014 --restart --set 'spacing="60 mm"' --time-limit=7
finish
