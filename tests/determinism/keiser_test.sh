#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The four scenes of Keiser et al. 2005 with surfaces, coarse. Bits, frames and logs are the same on 1, 2, 3,
# 4 and 7 ranks and over a restart.
. "$(dirname "$0")/../support/run.sh"
. "$(dirname "$0")/../support/surface_output.sh"
for scene in ${SCENES:-fluid freezing melting_fast melting_slow}; do
  settings "keiser/$scene"
  sameOnAllRanks "$scene" 1000000 "${CUTS:-100 200}" "$scenes/keiser/$scene.toml" "${set[@]}"
  surfels=$(counted "$work/$scene.1" surfels)
  [ "${surfels:-0}" -gt 100 ] || fail "$scene: $surfels surfels"
  echo "$scene: $surfels surfels, $(counted "$work/$scene.1" updates) updates, \
$(counted "$work/$scene.1" births) births, $(counted "$work/$scene.1" splits) splits, \
$(counted "$work/$scene.1" merges) merges"
  rm -rf "${work:?}/$scene".*
done
finish
