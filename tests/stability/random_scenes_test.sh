#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# random_scenes_test.sh BUILD [COUNT] [FIRST SEED]: random scenes (random_scene.cpp) on 1 to 4 ranks. Each
# must end in one of three ways:
#   exit 0  a finite summary with the residual of the ledger;
#   exit 4  one message that names the particle, the step and the time, a summary with the failure, and a
#           checkpoint of the last snapshot, from which the run can continue.
#   exit 2  the message that a body has no particle, since random shapes may leave nothing of a body.
# Anything else is a failure: another refused scene (an error of the generator), a crash, an abort, a hang,
# an error of MPI, several messages. Every tenth seed (EVERY) also runs on 1 and on 3 ranks. It also runs in
# two parts on 2 and 4, and from there with another coefficient on 1 and 3. All must give the same bits,
# frames included. 20 seeds; 500 with THAW_NIGHTLY=1. KEEP=FOLDER keeps the runs, with report.txt: one line
# per seed, "seed ranks particles exit residual step what" (the residual is relative to the largest term of
# the energy).
. "$(dirname "$0")/../support/run.sh"
count=${2:-$([ "${THAW_NIGHTLY:-0}" = 1 ] && echo 500 || echo 20)}
first=${3:-1}
export build thaw steps=${STEPS:-400} limit=${LIMIT:-120} every=${EVERY:-10}
export folder=${KEEP:-$work}
mkdir -p "$folder"

oneScene() {  # oneScene SEED: prints a line of the report
  local seed=$1 ranks=$((1 + $1 % 4)) code here=$folder/$1 what=ok residual=- particles=- step=-
  mkdir -p "$here"
  "$build/tests/random_scene" "$seed" >"$here/scene.toml"
  run() {
    timeout -k 5 "$limit" mpirun --allow-run-as-root --oversubscribe --bind-to none -n "$1" "$thaw" \
      run "$here/scene.toml" --steps "$steps" --out "$here/$2" "${@:3}" >"$here/$2.log" 2>&1
  }
  equal() {
    "$thaw" compare --frames "$here/$1" "$here/$2" >"$here/compare.log" 2>&1 ||
      what="$3 DIFFER: $(head -n 3 "$here/compare.log" | tr '\n' ' ')"
  }
  field() {
    sed -n 's/.*"'"$1"'": *"\{0,1\}\([^",]*\)"\{0,1\}.*/\1/p' "$here/out/summary.json" 2>/dev/null | head -n 1
  }
  run "$ranks" out
  code=$?
  local errors
  errors=$(grep -a -c 'error: ' "$here/out.log")
  case $code in
    0)
      residual=$(grep -a -o 'residual [^ ]* J ([^)]*)' "$here/out.log" | tail -n 1 | sed 's/.*(\(.*\))/\1/')
      particles=$(field particles) step=$(field step)
      [ -n "$residual" ] || what="NO RESIDUAL"
      # Warnings, the last entry, may quote the numbers of a failure that a retry has mended.
      sed '/^ *"warnings":/,$d' "$here/out/summary.json" |
        grep -q ': *null\|[nN]a[nN]\|[^a-z]inf[^a-z]' && what="NOT FINITE"
      [ "$errors" = 0 ] || what="ERROR BUT EXIT 0"
      ;;
    4)
      what=$(grep -a -o 'blew up.*' "$here/out.log" | head -n 1)
      particles=$(field particles) step=$(field step)
      grep -a -q "error: .*blew up at step [0-9]*, t .* s, dt .* s: .*\(particle [0-9]* of \
\(body\|emitter\) '.* has a velocity of .* and a force of\|no single particle is responsible\)" \
        "$here/out.log" || what="EXIT 4 WITHOUT ITS MESSAGE"
      grep -a -q 'the checkpoint holds step\|the last checkpoint is older' "$here/out.log" ||
        what="EXIT 4, NOTHING ABOUT A CHECKPOINT"
      "$thaw" info "$here/out" --json >"$here/info.log" 2>&1 || what="EXIT 4 WITHOUT A CHECKPOINT"
      [ "$errors" = 1 ] || what="$errors MESSAGES, NOT 1"
      [ "$(field status)" = failed ] || what="BLEW UP, SUMMARY SAYS '$(field status)'"
      ;;
    2)
      what=$(grep -a 'error: ' "$here/out.log" | head -n 1 | sed 's/.*error: /refused: /')
      [ "$errors" -ge 1 ] || what="REFUSED WITHOUT A MESSAGE"
      grep -a -q 'step 1 ' "$here/out.log" && what="REFUSED AFTER THE FIRST STEP"
      ;;
    124 | 137) what="HANGS" ;;
    *) what="EXIT CODE $code: $(grep -a -m1 'error\|signal\|rror' "$here/out.log")" ;;
  esac
  grep -a -q 'terminate called\|Segmentation\|Signal:\|MPI_ABORT\|Assertion' "$here/out.log" &&
    what="CRASHED: $what"
  if [ $((seed % every)) = 0 ] && [ "$code" = 0 ]; then
    rm -rf "$here/out"
    run 1 one
    run 3 three
    equal one three "1 AND 3 RANKS"
    if run 2 parts --steps $((step / 2)); then
      cp -r "$here/parts" "$here/change.1"
      cp -r "$here/parts" "$here/change.3"
      run 4 parts --resume
      equal one parts "WHOLE AND IN PARTS"
      run 1 change.1 --restart --set numerics.cfl_elastic=0.35 --set numerics.cfl_sound=0.35
      code=$?
      run 3 change.3 --restart --set numerics.cfl_elastic=0.35 --set numerics.cfl_sound=0.35
      [ $? = $code ] || what="OTHER COEFFICIENTS, 1 AND 3 RANKS END DIFFERENTLY"
      [ $code = 4 ] || equal change.1 change.3 "OTHER COEFFICIENTS, 1 AND 3 RANKS"
      code=0
    fi
    [ "$what" = ok ] && rm -rf "$here"/{one,three,parts,change.?}
  fi
  rm -rf "$here/out"
  echo "$seed $ranks $particles $code $residual $step $what"
}
export -f oneScene

seq "$first" $((first + count - 1)) | xargs -P "${JOBS:-2}" -I{} bash -c 'oneScene {}' >"$folder/lines.txt"
sort -n "$folder/lines.txt" >"$folder/report.txt"
[ "$(wc -l <"$folder/report.txt")" = "$count" ] || fail "not one line for each seed"
while read -r seed _ _ _ _ _ what; do
  case $what in ok | blew\ up* | refused:\ body*has\ no\ particle*) ;; *) fail "seed $seed: $what" ;; esac
done <"$folder/report.txt"
awk '{ n[$4]++ } $4 == 0 { r = $5 + 0; if (r < 0) r = -r; if (r > 0.05) large++; else if (r > 0.01) middle++ }
  END {
    printf "%d done (%d with more than 5 %% of the energy unexplained, ", n[0], large
    printf "%d with 1 to 5 %%), %d blew up, %d refused\n", middle, n[4], n[2]
  }' "$folder/report.txt"
grep -v ' 0 [^ ]* [0-9]* ok$' "$folder/report.txt"
finish
