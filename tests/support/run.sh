# Shared by the script tests: $1 is the build folder. Sets thaw, scenes, work (a fresh folder, removed at the end), and launch N ...
set -u
build=$1
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scenes=$source_dir/scenes
thaw=$build/thaw
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }
launch() {  # launch RANKS ARGUMENTS: thaw under mpirun, never longer than five minutes
  local ranks=$1
  shift
  timeout 300 mpirun --allow-run-as-root --oversubscribe --bind-to none -n "$ranks" "$thaw" "$@"
}
finish() { [ "$failures" -eq 0 ] && echo "all passed" || { echo "$failures failures"; exit 1; }; }
