# SPDX-License-Identifier: Apache-2.0
# Shared by the script tests of the surface, after run.sh. Functions refer to runs of the scene $scene.
same() {  # same A B WHAT: checkpoint, logs, both series and all their frames
  sameRuns "$1" "$2" "$3" surface.csv events.csv "frames/$scene.hdf.series" \
    "frames/${scene}_surface.hdf.series"
}
counted() { sed -n '/"surface": {/,$p' "$1/summary.json" | value - "$2"; }
