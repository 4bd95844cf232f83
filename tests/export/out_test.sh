#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Names and numbers that exports and pictures cannot use are refused, with what is expected.
. "$(dirname "$0")/../support/run.sh"
"$thaw" run "$source_dir/tests/export/scene.toml" --set end=0.05 --out "$work/run" >"$work/log" 2>&1
expectExit 0 "run"
frame=$(echo "$work"/run/frames/*_surface_000001.hdf)
refused() {  # refused CODE MESSAGE COMMAND ARGUMENTS: one line, without names of C++
  local code=$1 message=$2
  shift 2
  "$thaw" "$@" >"$work/log" 2>&1; expectExit "$code" "$*"
  expectMessage "$message" "$*"
  grep -q 'filesystem error' "$work/log" && fail "$*: a raw message"
}
refused 3 'surface_000001.hdf: is a file: a page needs the folder of a run$' export "$frame" --as html
refused 3 'is a file: a page needs the folder of a run$' view "$frame" --no-open
refused 3 'is a file: expected the folder of a run$' plot "$frame"

touch "$work/old.usd" "$work/file"
refused 2 "obj writes a file for each of 2 frames: expected a folder, got $work/old.usd$" \
  export "$work/run" --as obj --out "$work/old.usd"
refused 2 "expected a folder, got $work/new.obj$" export "$work/run" --as obj --out "$work/new.obj"
refused 2 "expected a folder, got $work/file$" export "$work/run" --as vtp --out "$work/file"
refused 2 "expected a folder or a file that ends in .ply, got $work/new.obj$" \
  export "$frame" --as ply --out "$work/new.obj"
refused 2 'expected a folder or a file that ends in .html' export "$work/run" --as html --out "$work/x.abc"
formats="ply-discs pov vtp ply obj usd usda vtkhdf bgeo"
"$thaw" export "$work/run" --as html --out "$work/page.html" >"$work/log" 2>&1
grep -q 'built without its page' "$work/log" || formats+=" html"
for as in $formats; do
  refused 3 "$work/file: is a file: expected a folder$" export "$work/run" --as $as --out "$work/file/out"
  refused 3 '/proc/none: cannot be created: ' export "$work/run" --as $as --out /proc/none
done
refused 3 "$work/file: is a file: expected a folder$" render "$frame" --out "$work/file/out" --width 64 \
  --height 48
[ -e "$work/new.obj" ] && fail "a refused name exists"
"$thaw" export "$frame" --as ply-discs --out "$work/one.ply" >"$work/log" 2>&1; expectExit 0 "one frame"
[ -s "$work/one.ply" ] || fail "a file of one frame"
mkdir "$work/v.1"
"$thaw" export "$work/run" --as obj --out "$work/v.1" >"$work/log" 2>&1; expectExit 0 "a folder with a dot"

png='expected a name that ends in .png'
refused 2 "$png" preview "$scenes/beam.toml" --out "$work/x.jpg"
refused 2 "$png" plot "$work/run" --out "$work/x.svg"
refused 2 "$png" render "$work/run" --sheet "$work/x.jpg"
[ -e "$work/x.jpg" ] && fail "a picture of another name"
for number in nan inf -inf; do
  finite="expected a finite number, not '$number'"
  for key in min max cell; do refused 2 "$finite" export "$work/run" --as ply --$key=$number; done
  for key in min max fov radius rate; do refused 2 "$finite" render "$work/run" --$key=$number; done
  refused 2 "$finite" render "$work/run" --from $number 0 1 --at 0 0 0
  refused 2 "$finite" compare "$frame" "$frame" --tolerance=$number
done
finish
