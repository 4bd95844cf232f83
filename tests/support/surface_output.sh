# Shared by the script tests of the surface; after run.sh. Of runs of the scene $scene.
sameOutput() {  # sameOutput A B WHAT: checkpoint, logs, both series and all their frames
  "$thaw" compare --frames "$1" "$2" >"$work/log" 2>&1 || { fail "$3: checkpoints or frames differ"; head -n 20 "$work/log"; return; }
  local name
  for name in surface.csv events.csv "frames/$scene.hdf.series" "frames/${scene}_surface.hdf.series"; do
    cmp -s "$1/$name" "$2/$name" || { fail "$3: $name differs"; diff "$1/$name" "$2/$name" | head -n 5; }
  done
}
counted() { sed -n '/"surface": {/,$p' "$1/summary.json" | value - "$2"; }
