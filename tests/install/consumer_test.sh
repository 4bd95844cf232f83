#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the build folder $1 to a temporary prefix. The programs of examples/cpp, which see only the
# installed files, step scenes: from code, from text, and from a file with the result of `thaw run`. So do the
# programs that docs/howto/library.md prints.
set -euo pipefail
build=${1:?usage: consumer_test.sh BUILD_FOLDER}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
prefix=$dir/prefix
python=$(command -v /usr/bin/python3 || command -v python3)
fail() { echo "FAILED: $*"; exit 1; }

cmake --install "$build" --prefix "$prefix" >/dev/null
"$prefix/bin/thaw" --help >/dev/null
for file in share/man/man1/thaw.1 share/bash-completion/completions/thaw share/thaw/frontier.csv \
  share/thaw/scenes/dam_break.toml; do
  [ -s "$prefix/$file" ] || fail "$file is not installed"
done
for header in core/solid/elasticity/moment.hpp io/commands/run.hpp; do  # no part of the interface
  [ ! -e "$prefix/include/thaw/$header" ] || fail "$header is installed"
done

# The programs see only the installed files, not the source tree or the build folder.
consumer=$dir/examples
cp -r "$root/examples/cpp" "$consumer"
generator=$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$build/CMakeCache.txt")
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
flags=$(sed -n 's/^THAW_SANITIZE:STRING=\(.\+\)/-fsanitize=\1/p' "$build/CMakeCache.txt")
buildProgram() {  # buildProgram FOLDER: into FOLDER/build
  (cd "$1" && cmake -G "$generator" -B build -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$compiler" \
    -DCMAKE_CXX_FLAGS="$flags" >log 2>&1 && cmake --build build >>log 2>&1) || { cat "$1/log"; exit 1; }
}
buildProgram "$consumer"
"$consumer/build/falling_cube"
"$consumer/build/phases"
for example in trap capsule mooney attraction; do "$consumer/build/$example" "$dir/$example"; done

# A field is in frames, and continues after a restart.
"$consumer/build/lamp"
mpirun -n 2 "$consumer/build/lamp" "$dir/lamp"
"$python" - "$prefix" "$dir/lamp" <<'END'
import glob, sys
sys.path.insert(0, glob.glob(sys.argv[1] + '/lib*/python3*/dist-packages')[0])
import thaw
run = thaw.open(sys.argv[2])
dose = run.frames[-1]['dose']
assert abs(dose.max() - 500 * 0.2) < 1e-3 and dose.min() == 0, (dose.min(), dose.max())
assert any('lamp' in line for line in run.summary.modules), run.summary.modules
END
# A program without the extension refuses its scenes.
cp "$prefix/share/thaw/scenes/dam_break.toml" "$dir/lamp.toml"
printf '[extension.lamp]\npower = "1 W/kg"\n' >>"$dir/lamp.toml"
if "$prefix/bin/thaw" run "$dir/lamp.toml" --out "$dir/refused" >"$dir/log" 2>&1; then
  fail "a program without the extension runs its scene"
fi
grep -q "extension.lamp: unknown extension" "$dir/log" || { cat "$dir/log"; exit 1; }

# The same steps by the program.
scene=$prefix/share/thaw/scenes/dam_break.toml steps=73
"$consumer/build/run_scene" "$scene" "$steps" | tee "$dir/found"
"$prefix/bin/thaw" run "$scene" --set spacing=0.05 --steps "$steps" --out "$dir/out" >"$dir/log" ||
  { cat "$dir/log"; exit 1; }
"$prefix/bin/thaw" info "$dir/out" --json >"$dir/info"
"$python" - "$dir/info" >"$dir/expected" <<'END'
import json, sys
last = json.load(open(sys.argv[1]))["checkpoints"][-1]
print(f'particles {last["particles"]}\nstep {last["step"]}\ntime {last["time"]:.17g}')
END
diff "$dir/found" "$dir/expected" || fail "the consumer's steps differ from those of thaw run"

mpirun -n 3 "$consumer/build/two_groups" "$scene" "$dir/two_groups" | sort >"$dir/groups"
[ "$(grep -c '^group [01]: ' "$dir/groups")" = 2 ] || fail "both groups step: $(cat "$dir/groups")"

# The picture of the manual.
if "$python" -c 'import matplotlib' 2>/dev/null; then
  PYTHONPATH=$root/python "$python" "$consumer/plot.py" "$dir" "$dir/examples.png"
  head -c 4 "$dir/examples.png" | grep -q PNG || fail "the picture of the examples"
fi

source=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")
if grep -rlF -e "$source/" "$prefix/lib"*/cmake; then fail "the installed package names the source tree"; fi

# Files of the manual are blocks whose first line names them. Programs of one source file need no instruction
# sets.
manual=$dir/manual
mkdir "$manual"
awk -v folder="$manual/" '/^```/ { file = "" }
  start && /^(\/\/|#) [A-Za-z_]+\.(cpp|txt|toml)(,|$)/ { file = folder $2; sub(/,$/, "", file) }
  { start = /^```(cpp|cmake|toml)/ }
  file != "" { print > file }' "$root/docs/howto/library.md"
for program in heater springs quartic pebble; do
  folder=$dir/$program
  mkdir "$folder"
  cp "$manual/$program"* "$folder"
  sed "s/springs/$program/g" "$manual/CMakeLists.txt" >"$folder/CMakeLists.txt"
  [ -f "$folder/${program}_isa.cpp" ] || sed -i '/^thaw_instruction_sets/d' "$folder/CMakeLists.txt"
  buildProgram "$folder"
  (cd "$folder" && build/"$program" >log 2>&1) || { cat "$folder/log"; fail "$program of the manual"; }
  "$python" - "$folder/out/$program/summary.json" "$program" <<'END'
import json, sys
summary = json.load(open(sys.argv[1]))
ledger = summary['ledger']
energy = ledger['now']['kinetic_J'] + ledger['now']['elastic_J']
residual = ledger['residual']['mechanical_energy_J']
assert summary['status'] == 'done' and not summary['warnings'], summary['warnings']
assert any(sys.argv[2] in line for line in summary['modules']), summary['modules']
assert abs(residual) < 5e-3 * energy, (residual, energy)
END
done
