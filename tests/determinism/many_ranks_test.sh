#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The same bits on many more ranks than there are cores, or cells in some scenes: a liquid, a solid, melting
# with a surface, oriented particles, a sheet. The default is 16 ranks and few steps. RANKS="16 32 64"
# STEPS=40 takes some minutes (docs/theory/parallel.md). SCENES selects scenes.
. "$(dirname "$0")/../support/run.sh"
export OMPI_MCA_mpi_yield_when_idle=1
steps=${STEPS:-6}
for which in ${SCENES:-fluid elastic melting oriented sheet}; do
  n=$steps
  case $which in
    fluid) file=dam_break; settings $file ;;
    elastic) file=beam; settings $file ;;
    melting)
      file=melt
      settings $file
      set+=(--set 'body.bust.place.bottom=[0,0,0.004]' --set 'body.bust.temperature=312'
        --set 'obstacle.plate.temperature=900' --set material.wax.conductivity=100000
        --set surface.every_steps=5)
      ;;
    oriented) file=oriented/weld; settings $file ;;
    sheet) file=sheet/cloth; set=(--set sheet.cloth.spacing="3 cm" --set spacing="2 cm") ;;
    *) fail "unknown scene $which"; continue ;;
  esac
  for ranks in 1 ${RANKS:-16}; do
    launch "$ranks" run "$scenes/$file.toml" "${set[@]}" --set output.every=10 --steps "$n" \
      --out "$work/$which.$ranks" >"$work/log" 2>&1
    code=$?
    [ "$code" -eq 0 ] || { fail "$which on $ranks ranks: exit $code"; tail -n 5 "$work/log"; continue; }
    [ "$ranks" = 1 ] || "$thaw" compare "$work/$which.1" "$work/$which.$ranks" >"$work/log" 2>&1 || {
      fail "$which: 1 and $ranks ranks differ"
      head -n 20 "$work/log"
    }
  done
  echo "$which: $(value "$work/$which.1/summary.json" particles) particles, \
$(value "$work/$which.1/summary.json" step) steps"
  rm -rf "${work:?}/$which".*
done
finish
