# SPDX-License-Identifier: Apache-2.0
# Shared by the tests of bad input, after run.sh: $1 is the build folder. Cases run side by side on three
# ranks. Each expects the documented exit code, one clear message (once, not once per rank), no crash and no
# hang. Ends with `allCases`.
. "$(dirname "${BASH_SOURCE[0]}")/run.sh"
limit=${LIMIT:-60}  # seconds per case

# A small valid scene. Every case below breaks it in one place.
cat >"$work/good.toml" <<'SCENE'
title = "a block"
spacing = "2 cm"
end = "20 ms"
[domain]
min = [-0.5, -0.5, -0.1]
max = [0.5, 0.5, 0.5]
[material.jelly]
young = "20 kPa"
[[body]]
name = "block"
box = { size = [0.1, 0.1, 0.1] }
material = "jelly"
place = { move = [0, 0, 0.1] }
[[obstacle]]
name = "floor"
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
SCENE

# Cases run side by side, each in its own folder: most of the time is the start of three processes.
cases=0
started() {  # started COMMAND ARGUMENTS: runs a case in the background
  while [ "$(jobs -rp | wc -l)" -ge "${JOBS:-$(nproc)}" ]; do wait -n; done
  cases=$((cases + 1))
  ( place=$work/case.$cases; mkdir "$place"; failures=0; "$@" >"$place/said"; exit "$failures" ) &
  pids+=($!)
}
pids=()
allEnded() {
  local pid i=0
  for pid in "${pids[@]}"; do
    i=$((i + 1))
    wait "$pid" || { failures=$((failures + 1)); cat "$work/case.$i/said"; }
  done
}

# call COMMAND SCENE [options]: runs thaw on three ranks; sets $code and writes the output to $place/log
call() {
  local command=$1 scene=$2
  shift 2
  local out=()
  [ "$command" = run ] && out=(--out "$place/out")
  timeout -k 5 "$limit" mpirun --allow-run-as-root --oversubscribe \
    --bind-to none -n 3 "$thaw" "$command" "$scene" "${out[@]}" "$@" >"$place/log" 2>&1
  code=$?
}

# rejects CASE PATTERN CODE COMMAND SCENE [options]: expects the exit code, and the pattern in exactly one
# line
rejects() { started isRejected "$@"; }
isRejected() {
  local name=$1 pattern=$2 wanted=$3
  shift 3
  call "$@"
  local times
  times=$(grep -a -c -E -- "$pattern" "$place/log")
  if [ "$code" = 124 ] || [ "$code" = 137 ]; then fail "$name: hangs (no end after $limit s)"
  elif [ "$code" != "$wanted" ]; then fail "$name: exit code $code instead of $wanted"; head -n 5 "$place/log"
  elif [ "$times" != 1 ]; then fail "$name: '$pattern' in $times lines instead of 1"; head -n 8 "$place/log"
  elif grep -a -q -E 'terminate called|Segmentation|Signal:|MPI_ABORT' "$place/log"; then
    fail "$name: crashed"
    head -n 8 "$place/log"
  fi
}

# accepts CASE COMMAND SCENE [options]: expects exit code 0
accepts() { started isAccepted "$@"; }
isAccepted() {
  local name=$1
  shift
  call "$@"
  [ "$code" = 0 ] || { fail "$name: exit code $code"; head -n 8 "$place/log"; }
}

# scene NAME SED-SCRIPT: an edited copy of the valid scene
scene() { sed -E "$2" "$work/good.toml" >"$work/$1.toml"; echo "$work/$1.toml"; }
good=$work/good.toml

# bodyTypes NAME <<<TABLES: a scene without continuum and with the given tables, which begin in line 6
printf 'spacing = 0.05\nend = 0.01\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n' >"$work/bodyTypes.toml"
bodyTypes() { { cat "$work/bodyTypes.toml"; cat; } >"$work/$1.toml"; echo "$work/$1.toml"; }
# warns CASE PATTERN NAME TABLES: expects success with one warning
warns() { rejects "$1" "^warning: .*/$2" 0 check "$(bodyTypes "$3" <<<"$4")"; }
allCases() { allEnded; echo "$cases cases"; finish; }
