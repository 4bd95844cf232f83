#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the package with its compiled part by `pip install .` into a virtual environment, without network,
# and simulates with it. The build takes as long as one of thaw, so the test is skipped unless THAW_PIP_BUILD
# names its folder, which is kept for the next call. numpy, h5py and setuptools are those of Debian.
set -euo pipefail
build=${1:?usage: pip_test.sh BUILD_FOLDER}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
if [ -z "${THAW_PIP_BUILD:-}" ]; then
  echo "skipped: THAW_PIP_BUILD names no folder for the build"
  exit 77
fi
python=$(command -v /usr/bin/python3 || command -v python3)
for module in pip ensurepip setuptools wheel numpy h5py; do
  "$python" -c "import $module" 2>/dev/null || { echo "skipped: $python has no module $module"; exit 77; }
done
if ! grep -q '^CMAKE_BUILD_TYPE:STRING=Release$' "$build/CMakeCache.txt"; then
  echo "skipped: pip builds the preset release only"
  exit 77
fi
if ! ls "$build"/python/thaw/_core*.so >/dev/null 2>&1; then
  echo "skipped: $build has no compiled part, as without Python's headers and pybind11"
  exit 77
fi
dir=$(mktemp -d)
# setuptools writes beside setup.py
trap 'rm -rf "$dir" "$root"/build/lib.* "$root"/build/bdist.* "$root"/thaw.egg-info' EXIT
fail() { echo "FAILED: $*"; exit 1; }

"$python" -m venv --system-site-packages "$dir/venv"
(cd "$root" && THAW_BUILD=$THAW_PIP_BUILD "$dir/venv/bin/python" -m pip install --no-index \
  --no-deps --no-build-isolation . >"$dir/log" 2>&1) || { tail -n 60 "$dir/log"; fail "pip install"; }

cat >"$dir/drop.py" <<'END'
import sys
import thaw
assert thaw.__file__.startswith(sys.prefix), thaw.__file__
sim = thaw.Simulation({
    "spacing": 0.05, "end": 1, "domain": {"min": [-1, -1, -1], "max": [1, 1, 1]},
    "material": {"water": {"density": 1000, "sound_speed": 20}},
    "body": [{"sphere": {"radius": 0.3}, "material": "water"}],
})
sim.run(steps=5)
fall = sim.ledger["momentum_z"] / sim.ledger["mass"]
assert abs(fall + 9.81 * sim.time) < 1e-9, fall
if sim.rank == 0: print(thaw.__version__, sim.steps, sim.ranks)
END
version=$(sed -n 's/^project(thaw VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
cd "$dir"
[ "$(venv/bin/python drop.py)" = "$version 5 1" ] || fail "a simulation"
if "$python" -c "import mpi4py" 2>/dev/null; then
  [ "$(mpirun -q -n 2 venv/bin/python drop.py)" = "$version 5 2" ] || fail "a simulation on two ranks"
fi
