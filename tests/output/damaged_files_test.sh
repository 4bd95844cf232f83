#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Damaged checkpoints are refused before HDF5 opens them, and the other one is used. If both are damaged, the
# run ends with exit code 3. Damaged frames end no program by a signal. THAW_DAMAGES sets the number of
# damaged copies per checkpoint (140).
. "$(dirname "$0")/../support/run.sh"
export OMPI_MCA_io=romio321
settings freeze
number=${THAW_DAMAGES:-140}
out=$work/run
launch 2 run "$scenes/freeze.toml" "${set[@]}" --steps 7 --out "$out" >"$work/log" 2>&1
expectExit 0 "first checkpoint"
launch 2 run "$scenes/freeze.toml" "${set[@]}" --steps 9 --restart --out "$out" >"$work/log" 2>&1
expectExit 0 "second checkpoint"
a=$out/checkpoint/a.hdf b=$out/checkpoint/b.hdf
frame=$(ls "$out"/frames/*.hdf | tail -n 1)
"$build/tests/damage_files" "$number" "$b" 1 || fail "checkpoint"
"$build/tests/damage_files" 70 "$frame" 2 || fail "frame"

# through the program: first the newest is damaged, then both
restart() {
  launch "$1" run "$scenes/freeze.toml" "${set[@]}" --steps 9 --restart --out "$work/copy" >"$work/log" 2>&1
}
signals() { ! grep -qiE 'signal|Segmentation|terminate called' "$work/log" || fail "$1: $(cat "$work/log")"; }
for seed in 1 2 3 4 5 6 7; do
  rm -rf "$work/copy"
  cp -r "$out" "$work/copy"
  "$build/tests/damage_files" 1 "$b" $seed --keep && mv "$b.damaged" "$work/copy/checkpoint/b.hdf"
  "$thaw" info "$work/copy" >"$work/log" 2>&1; signals "info, seed $seed"
  restart $((1 + seed % 3)); expectExit 0 "the newest is damaged, seed $seed"
  expectMessage "^warning: .*b.hdf: " "the newest is damaged, seed $seed"
  expectMessage "continues at .*, step 7, from .*a.hdf" "the newest is damaged, seed $seed"
done
same "$out" "$work/copy" "from the older checkpoint"
"$build/tests/damage_files" 1 "$a" 5 --keep && mv "$a.damaged" "$work/copy/checkpoint/a.hdf"
"$build/tests/damage_files" 1 "$b" 3 --keep && mv "$b.damaged" "$work/copy/checkpoint/b.hdf"
restart 2; expectExit 3 "both are damaged"
expectMessage "^error: no checkpoint can be read: .*a.hdf: .*b.hdf: " "both are damaged"
"$thaw" compare "$out" "$work/copy" >"$work/log" 2>&1; expectExit 3 "compare with damaged ones"

# damaged frames, through the programs that read them
for seed in 1 2 3 4 5 6 7; do
  "$build/tests/damage_files" 1 "$frame" $seed --keep
  mkdir -p "$work/pictures"
  cp "$frame.damaged" "$work/pictures/frame.hdf"
  for command in info render; do
    timeout 60 "$thaw" $command "$work/pictures/frame.hdf" >"$work/log" 2>&1
    [ $? -lt 124 ] || fail "$command of a damaged frame, seed $seed: $(tail -n 3 "$work/log")"
  done
done
finish
