#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A full disk, a file size limit, or a folder that cannot be made or written. The run ends with exit code 3 on
# every rank and one message, without a hang. It leaves a summary if there is room, whole earlier frames, and
# no partial files.
. "$(dirname "$0")/../support/run.sh"
scene=$scenes/drop.toml
settings drop
set+=(--set spacing=0.00064)
run() { launch 3 run "$scene" "${set[@]}" --out "$@" >"$work/log" 2>&1; }
oneError() {  # oneError WHAT
  [ "$(grep -c '^error: ' "$work/log")" = 1 ] || { fail "$1: not one error message"; cat "$work/log"; }
}
wholeFrames() {  # wholeFrames FOLDER WHAT: at least one, all readable, no .part
  local n=0 f
  for f in "$1"/frames/*.hdf; do
    [ -f "$f" ] || continue
    n=$((n + 1))
    "$thaw" info "$f" >/dev/null 2>&1 || fail "$2: $f cannot be read"
  done
  [ "$n" -gt 0 ] || fail "$2: no frames"
  [ -z "$(find "$1" -name '*.part')" ] || fail "$2: left $(find "$1" -name '*.part')"
}

: >"$work/file"
run "$work/file/out"; expectExit 3 "folder below a file"; oneError "folder below a file"

# a size limit between a frame and a checkpoint: the first frames are written, the first checkpoint fails
run "$work/size" --steps 3; expectExit 0 "without a limit"
frame=$(stat -c %s "$work/size"/frames/drop_000000.hdf)
checkpoint=$(stat -c %s "$work/size"/checkpoint/a.hdf)
rm -rf "$work/size"
between=$((frame + 290000))  # fits a frame with additions of HDF5 (see the free-space check)
[ "$checkpoint" -gt $((between + 10000)) ] ||
  fail "a checkpoint ($checkpoint bytes) is not much larger than a frame ($frame bytes)"
# the limit applies to the ranks only, which use TCP: files in memory of mpirun and its shared-memory
# transport may be larger
printf '#!/bin/bash\nulimit -f %d\nexec "%s" "$@"\n' $((between / 1024)) "$thaw" >"$work/limited"
chmod +x "$work/limited"
limited() { OMPI_MCA_btl=self,tcp thaw=$work/limited run "$@"; }
limited "$work/size" --steps 3; expectExit 3 "ulimit -f"
oneError "ulimit -f"; wholeFrames "$work/size" "ulimit -f"
[ "$(value "$work/size/summary.json" status)" = failed ] ||
  fail "ulimit -f: the summary says '$(value "$work/size/summary.json" status)'"
[ "$(value "$work/size/summary.json" particles)" -gt 0 ] || fail "ulimit -f: the summary has no particles"

mkdir "$work/disk"
if mount -t tmpfs -o size=$((8 * frame)) tmpfs "$work/disk" 2>/dev/null; then
  trap 'umount "$work/disk"; rm -rf "$work"' EXIT
  run "$work/disk/run" --set output.every=1e-5; expectExit 3 "full disk"
  oneError "full disk"; expectMessage "not enough space" "full disk"; wholeFrames "$work/disk/run" "full disk"
  [ "$(value "$work/disk/run/summary.json" status)" = failed ] ||
    fail "full disk: the summary says '$(value "$work/disk/run/summary.json" status)'"
else
  echo "a small file system cannot be mounted here: the full disk is tested by ulimit only"
fi
finish
