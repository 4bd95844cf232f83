# SPDX-License-Identifier: Apache-2.0
# Functions shared by the scripts: packages, configuration, build, mpirun. Source it from bash.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release

# Packages that a bare Debian 12 lacks to build thaw. Tests also need python_packages. Their examples need
# example_packages and pip needs pip_packages, charts need chart_packages, and the manual docs_packages.
packages=(g++ cmake ninja-build openmpi-bin libopenmpi-dev libhdf5-openmpi-dev libeigen3-dev
  libtomlplusplus-dev libcli11-dev libfmt-dev nlohmann-json3-dev libmuparser-dev libpng-dev
  libnanoflann-dev libgtest-dev python3)
case ${CXX:-} in clang++*) packages+=("clang${CXX#clang++}") ;; esac  # CXX=clang++-14 selects Clang
python_packages=(python3-dev pybind11-dev python3-numpy python3-h5py python3-mpi4py python3-pytest)
example_packages=(python3-matplotlib python3-scipy)
pip_packages=(python3-pip python3-venv python3-setuptools python3-wheel)
chart_packages=(python3-matplotlib)
docs_packages=(python3-sphinx python3-myst-parser furo)
lint_packages=(black clang-format-14 clang-tidy-14 codespell git python3)

say() { printf '%s\n' "$*" >&2; }
# Prints the comment at the top of the running script, its help.
usage() { sed -n '2,/^[^#]/{/^# SPDX/d;s/^# \{0,1\}//p}' "$0"; }
fail() { say "$(basename "$0"): $*"; exit 1; }

# Prints those of the given packages that are not installed. It reads dpkg's data only: no network, a few
# milliseconds.
missingPackages() {
  local installed
  installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null |
    sed -n 's/^installed //p' || true)
  local package
  for package in "$@"; do grep -qxF -- "$package" <<<"$installed" || printf '%s\n' "$package"; done
}

# Installs missing packages among the given ones, as root or through sudo.
needPackages() {
  if ! command -v dpkg-query >/dev/null; then
    say "not a Debian system, so nothing is installed; the Debian names of the required packages are $*"
    return 0
  fi
  local missing
  mapfile -t missing < <(missingPackages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "missing packages and no sudo; run as root: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0)
  local log
  log=$(mktemp)
  if ! { "${apt[@]}" update && "${apt[@]}" install -y --no-install-recommends "${missing[@]}"; } \
    >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    rm -f "$log"
    fail "apt-get could not install ${missing[*]}"
  fi
  rm -f "$log"
}

# Number of cores that this process can use: its affinity, limited by a container's quota.
cores() {
  local n quota period
  n=$(nproc)
  if read -r quota period 2>/dev/null </sys/fs/cgroup/cpu.max && [ "$quota" != max ]; then
    local allowed=$(((quota + period - 1) / period))
    [ "$allowed" -ge "$n" ] || n=$allowed
  fi
  printf '%s\n' "$((n > 0 ? n : 1))"
}

# optionsToContinue RANKS OPTIONS...: prints the quoted options that continue a stopped run, each after a
# blank: changes of the scene, and ranks that are not the default. Length and start are left out.
optionsToContinue() {
  local again=()
  [ "$1" -eq "$(cores)" ] || again+=(--ranks "$1")
  shift
  while [ $# -gt 0 ]; do
    case "$1" in
      --steps | --time-limit) [ $# -lt 2 ] || shift ;;
      --steps=* | --time-limit=* | --restart | --resume | --force) ;;
      *) again+=("$1") ;;
    esac
    shift
  done
  [ ${#again[@]} -eq 0 ] || printf ' %q' "${again[@]}"
}

# configure PRESET LOG
configure() {
  mkdir -p "$root/build"
  (cd "$root" && cmake --preset "$1" >"$2" 2>&1) || { cat "$2" >&2; fail "configuring failed"; }
}

# configureAndBuild PRESET [TARGET...]: quiet unless it fails or standard error is a terminal.
configureAndBuild() {
  local preset=$1 target args=()
  shift
  for target in "$@"; do args+=(--target "$target"); done
  build=$root/build/$preset
  local log=$root/build/$preset.log
  configure "$preset" "$log"
  if [ -t 2 ]; then
    cmake --build "$build" -j "$(cores)" "${args[@]}" >&2 || fail "the build failed"
  else
    say "building ${*:-everything} (log: $log)"
    cmake --build "$build" -j "$(cores)" "${args[@]}" >>"$log" 2>&1 ||
      { tail -n 60 "$log" >&2; fail "the build failed"; }
  fi
}

# Settings for Open MPI as root, in containers, and with more ranks than cores.
openMpiSettings() {
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  # Containers forbid reading another process's memory. Slots and binding of batch systems do not apply.
  export OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_rmaps_base_oversubscribe=1
  export OMPI_MCA_hwloc_base_binding_policy=none
}

# Exits with 2 unless the argument can be a number of ranks.
checkRanks() {
  if [[ $1 =~ ^[1-9][0-9]{0,6}$ ]]; then return; fi
  say "$(basename "$0"): the number of ranks must be a positive whole number, not '$1'"
  exit 2
}

# onRanks N COMMAND...: runs a command under mpirun and returns its exit code.
onRanks() {
  local n=$1
  shift
  openMpiSettings
  if [ "$n" -gt "$(cores)" ]; then export OMPI_MCA_mpi_yield_when_idle=1; fi
  mpirun -q -n "$n" "$@"
}
