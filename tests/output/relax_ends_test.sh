#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Points of a ball with a third of the normals reversed: relaxation of the surface through them does not
# converge. It ends with progress lines, one warning, and the same bits on any number of ranks.
. "$(dirname "$0")/../support/run.sh"
awk 'BEGIN {
  n = 100
  for (k = 0; k < n; k++) {
    z = 1 - 2 * (k + .5) / n; r = sqrt(1 - z * z)
    a = 2.399963229728653 * k; x = r * cos(a); y = r * sin(a)
    s = (k * 7) % 3 ? 1 : -1
    places = places sprintf("[%.5f, %.5f, %.5f],\n", .2 * x, .2 * y, .2 * z)
    normals = normals sprintf("[%.5f, %.5f, %.5f],\n", s * x, s * y, s * z)
  }
  print "spacing = 0.05\nend = 0.01\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\ngravity = [0, 0, 0]"
  printf "[[oriented]]\nname = \"ball\"\npoints = [%s]\nnormals = [%s]\n", places, normals
  print "growth = \"borders\"\nremoval_distance = 0.6\nattract = 0.1\ncocircular = 1.5\ndamping = 60"
  print "spin_damping = 60\nrelax = 10000000\n[output]\nevery = 0.01"
}' >"$work/ball.toml"
for ranks in 1 2 3 4 7; do
  launch "$ranks" run "$work/ball.toml" --steps 2 --progress 0 --out "$work/$ranks" >"$work/log" 2>&1
  expectExit 0 "$ranks ranks"
  expectMessage '^oriented: iteration [1-9][0-9]* of relaxation, largest force .* [0-9]* particles, ' \
    "$ranks ranks"
  ended='^warning: oriented: [0-9]* iterations of relaxation; the largest force is .*e.* of stiffness'
  ended+=' times spacing: it ended before rest'
  [ "$(grep -c "$ended" "$work/log")" = 1 ] || fail "$ranks ranks: not one warning"
  said[ranks]=$(grep '^warning: oriented' "$work/log")
  [ "${said[ranks]}" = "${said[1]}" ] || fail "$ranks ranks: '${said[ranks]}', not '${said[1]}'"
  [ "$ranks" = 1 ] || same "$work/1" "$work/$ranks" "1 and $ranks ranks"
done
launch 2 relax "$work/ball.toml" --out "$work/relaxed" >"$work/log" 2>&1; expectExit 0 "relax"
expectMessage '^done .*relaxation made no further progress after [0-9]* iterations' "relax"
launch 2 run "$work/ball.toml" --restart --steps 2 --out "$work/relaxed" >"$work/log" 2>&1
expectExit 0 "restart of it"
finish
