#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Shared by the script tests: $1 is the build folder. Defines thaw, scenes, work (a new folder, removed at the
# end) and functions.
set -u
build=$(cd "$1" && pwd)
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scenes=$source_dir/scenes
thaw=$build/thaw
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }
mpi=(mpirun --allow-run-as-root --oversubscribe --bind-to none)
jellyBlock() {  # prints a scene: a small elastic block, for some steps
  cat <<'END'
spacing = 0.05
end = 0.01
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[material.jelly]
young = "20 kPa"
[[body]]
name = "block"
material = "jelly"
box = { size = [0.2, 0.2, 0.2] }
[output]
every = 0.01
END
}
launch() {  # launch RANKS ARGUMENTS: thaw under mpirun, for at most five minutes
  local ranks=$1
  shift
  timeout 300 "${mpi[@]}" -n "$ranks" "$thaw" "$@"
}
launchInBackground() {  # as launch, in the background; $launched is the process
  local ranks=$1
  shift
  "${mpi[@]}" -n "$ranks" "$thaw" "$@" &
  launched=$!
}
ranksOf() {  # ranksOf FOLDER: processes of thaw with this --out
  local p
  for p in /proc/[0-9]*; do
    [ "$(readlink "$p/exe" 2>/dev/null)" = "$(realpath "$thaw")" ] &&
      tr '\0' '\n' <"$p/cmdline" 2>/dev/null | grep -qxF -e "$1" && echo "${p#/proc/}"
  done
}
killAll() {  # killAll SIGNAL FOLDER: signals the ranks and mpirun
  local pids
  pids=$(ranksOf "$2")
  # shellcheck disable=SC2086
  kill "$1" $pids 2>/dev/null
  [ "$1" = -9 ] && kill -9 "$launched" 2>/dev/null
  wait "$launched" 2>/dev/null
}
settings() {  # settings SCENE: its "# test:" options into the array `set`
  local line
  line=$(sed -n 's/^# test: //p' "$scenes/$1.toml")
  eval "set=($line)"
}
testedScenes() {  # prints the names of scenes with such a line; fails if there is none
  local names
  names=$(grep -l '^# test: ' "$scenes"/*.toml | xargs -rn1 basename | sed 's/\.toml$//')
  [ -n "$names" ] && echo "$names" || echo "no-scene-with-a-test-line"
}
value() {  # value FILE|- KEY: first number or word of that key in JSON
  cat "$1" | sed -n 's/.*"'"$2"'": *"\{0,1\}\([^",]*\)"\{0,1\}.*/\1/p' | head -n 1
}
# checksums of a run's frames, with those of the surface
frameSums() { (cd "$1/frames" && sha256sum "$2"_*.hdf | LC_ALL=C sort); }
# frameIsLost BEFORE AFTER: true if a checksum of BEFORE is missing in AFTER
frameIsLost() { LC_ALL=C comm -23 <(echo "$1") <(echo "$2") | grep -q .; }
expectExit() {  # expectExit CODE WHAT: for the last command, whose output is in $work/log
  local code=$?
  [ "$code" -eq "$1" ] || { fail "$2: exit $code, not $1"; tail -n 5 "$work/log"; }
}
expectMessage() { grep -q -e "$1" "$work/log" || { fail "$2: no message '$1'"; tail -n 5 "$work/log"; }; }
# sameRuns A B WHAT FILE...: the last checkpoints, all frames and these files of two runs are equal byte by
# byte
sameRuns() {
  local a=$1 b=$2 what=$3 name
  shift 3
  "$thaw" compare --frames "$a" "$b" >"$work/log" 2>&1 || {
    fail "$what: checkpoints or frames differ"
    head -n 20 "$work/log"
    return
  }
  for name in "$@"; do
    cmp -s "$a/$name" "$b/$name" || { fail "$what: $name differs"; diff "$a/$name" "$b/$name" | head -n 5; }
  done
}
same() { sameRuns "$1" "$2" "$3"; }  # same A B WHAT: equality of two runs; a test may redefine it
# runInParts NAME CUTS SCENE OPTIONS...: runs into $work/NAME.parts up to each step of CUTS, on 3, 2, 4, 3,
# ... ranks in turn
runInParts() {
  local name=$1 cuts=$2 ranks=(3 2 4) part=0 cut
  shift 2
  for cut in $cuts; do
    launch "${ranks[part++ % 3]}" run "$@" --steps "$cut" --resume --out "$work/$name.parts" >"$work/log" 2>&1
    expectExit 0 "$name, in parts, to step $cut"
    [ -f "$work/$name.parts/summary.json" ] &&
      [ "$(value "$work/$name.parts/summary.json" step)" -le "$cut" ] ||
      fail "$name: not stopped at step $cut"
  done
}
# cutAndKilled NAME STEPS SCENE OPTIONS...: runs into $work/NAME.parts in three parts. It runs on 3 ranks to a
# third of the steps, on 2 until a kill with -9 at any moment, and on 4 to the end.
cutAndKilled() {
  local name=$1 steps=$2 scene=$3 third=$(($2 / 3)) parts=$work/$1.parts at
  shift 3
  launch 3 run "$scene" "$@" --steps "$third" --out "$parts" >"$work/log" 2>&1
  expectExit 0 "$name, first part"
  launchInBackground 2 run "$scene" "$@" --set output.checkpoint=0.05 --steps $((steps - 1)) --resume \
    --out "$parts" >"$work/log" 2>&1
  for _ in $(seq 200); do grep -q '^t ' "$work/log" && break; sleep 0.02; done
  sleep "0.0$((RANDOM % 10))"
  killAll -9 "$parts"
  at=$("$thaw" info "$parts" --json 2>"$work/log" | value - step)
  [ -n "$at" ] && [ "$at" -ge "$third" ] || {
    fail "$name: no checkpoint after the kill (step '$at')"
    cat "$work/log"
    return 1
  }
  echo "$name: killed at step $at of $steps"
  launch 4 run "$scene" "$@" --steps "$steps" --resume --out "$parts" >"$work/log" 2>&1
  expectExit 0 "$name, last part"
}
# sameOnAllRanks NAME STEPS CUTS SCENE OPTIONS...: a whole run on 7 ranks, and one in parts on 3, 2 and 4,
# equal the whole one on 1 (`same`). CUTS: the steps at which it stops; - for a third and two thirds; killed
# for cutAndKilled. ALL_RANKS=1 also runs whole on 2, 3 and 4. The runs stay in $work/NAME.1, NAME.7 and
# NAME.parts.
sameOnAllRanks() {
  local name=$1 steps=$2 cuts=$3 file=$4 ranks one
  shift 4
  whole() {
    launch "$1" run "$file" "${@:2}" --steps "$steps" --out "$work/$name.$1" >"$work/$name.log.$1" 2>&1
  }
  checked() { [ "$2" -eq 0 ] || { fail "$name on $1 ranks: exit $2"; tail -n 5 "$work/$name.log.$1"; }; }
  whole 1 "$@" & one=$!  # runs while the parts run
  case $cuts in
    killed) cutAndKilled "$name" "$steps" "$file" "$@" ;;
    -) runInParts "$name" "$((steps / 3)) $((steps * 2 / 3)) $steps" "$file" "$@" ;;
    *) runInParts "$name" "$cuts $steps" "$file" "$@" ;;
  esac
  wait "$one"; checked 1 $?
  for ranks in ${ALL_RANKS:+2 3 4} 7; do
    whole "$ranks" "$@"; checked "$ranks" $?
    same "$work/$name.1" "$work/$name.$ranks" "$name on 1 and $ranks ranks"
  done
  same "$work/$name.1" "$work/$name.parts" "$name, whole and in parts"
  echo "$name: $(value "$work/$name.1/summary.json" particles | grep . || echo no) particles, \
$(value "$work/$name.1/summary.json" step) steps"
}
finish() { [ "$failures" -eq 0 ] && echo "all passed" || { echo "$failures failures"; exit 1; }; }
