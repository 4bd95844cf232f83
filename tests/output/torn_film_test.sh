#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A liquid ball without surface tension bursts on a floor. In every frame its surface encloses the volume of
# its particles. A stream freezes with adapted density, and its plates keep their volume as well.
. "$(dirname "$0")/../support/run.sh"
cat >"$work/film.toml" <<'END'
spacing = "1.5 cm"
end = "0.36 s"
[domain]
min = [-0.5, -0.5, -0.1]
max = [0.5, 0.5, 1]
[material.jelly]
density = 1000
viscosity = 1
[[body]]
name = "ball"
sphere = { radius = 0.1 }
material = "jelly"
place = { move = [0, 0, 0.25] }
[[obstacle]]
name = "floor"
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
[surface]
[output]
every = "20 ms"
END
# worst FOLDER: largest relative volume error of a frame, in thousandths
worst() {
  awk -F, 'NR > 1 { p[$1] += $8; v[$1] += $9 }
    END {
      for (f in p) { d = v[f] / p[f] - 1; d = d < 0 ? -d : d; if (d > m) m = d }
      print int(1000 * m + 0.5)
    }' "$1/surface.csv"
}
launch 2 run "$work/film.toml" --out "$work/film" >"$work/log" 2>&1
expectExit 0 "the film"
off=$(worst "$work/film")
[ "$off" -le 5 ] || fail "the film's volume is off by $off thousandths"
settings keiser/freezing
launch 2 run "$scenes/keiser/freezing.toml" --out "$work/frozen" "${set[@]}" --set surface.adapt=0.45 \
  >"$work/log" 2>&1
expectExit 0 "the frozen stream"
frozen=$(worst "$work/frozen")
[ "$frozen" -le 10 ] || fail "the frozen plates' volume is off by $frozen thousandths"
echo "off by $off and $frozen thousandths"
finish
