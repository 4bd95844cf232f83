#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A bust falls on a hot box, is compressed, melts from below and jumps off its puddle. Its surface stays
# whole. Volume enforcement leaves out the elastic compression, deep surfels of the softening mesh are not
# removed as detached, and no second skin grows over its grooves.
. "$(dirname "$0")/../support/run.sh"
launch 2 run "$scenes/keiser/melting_slow.toml" --out "$work/bust" --set end=0.44 --set spacing=0.045 \
  --set surface.spacing=0.011 --set output.every=0.01 >"$work/log" 2>&1
expectExit 0 "the bust"
# largest relative volume error, in thousandths, over components of 300 particles and more
off=$(awk -F, 'NR > 1 && $5 > 300 { d = $9 / $14 - 1; d = d < 0 ? -d : d; if (d > m) m = d }
  END { print int(1000 * m + 0.5) }' "$work/bust/surface.csv")
[ "$off" -le 10 ] || fail "volumes are off by $off thousandths"
births=$(sed -n 's/.* iterations, \([0-9]*\) births.*/\1/p' "$work/log")
[ "${births:-99999}" -lt 18000 ] || fail "$births births: more than there are surfels"
echo "off by $off thousandths, $births births"
finish
