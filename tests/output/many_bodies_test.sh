#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# `thaw check` of 10,000 bodies ends within seconds with a screen of text: its cost is linear in the number of
# bodies.
. "$(dirname "$0")/../support/run.sh"
bodies() {  # bodies N: cubes of one particle on a square of N x N, in a thin periodic slab
  awk -v n="$1" 'BEGIN {
    print "spacing = 0.01\nend = 0.01\n[domain]\nmin = [-1, -1, -0.03]"
    print "max = [" n * 0.01 + 1 ", " n * 0.01 + 1 ", 0.03]"
    print "gravity = [0, 0, 0]\nsides = { z = \"periodic\" }\n[material.water]"
    for (i = 0; i < n; i++) for (j = 0; j < n; j++) {
      print "[[body]]\nmaterial = \"water\"\nvelocity = [" (-i) ", " j ", 0]"
      print "box = { size = [0.01, 0.01, 0.06] }"
      print "place = { move = [" (i + 0.5) * 0.01 ", " (j + 0.5) * 0.01 ", 0] }"
    }
  }'
}
bodies 100 >"$work/many.toml"
SECONDS=0
launch 1 check "$work/many.toml" >"$work/log" 2>&1; expectExit 0 "check of 10,000 bodies"
[ "$SECONDS" -le "${LIMIT:-30}" ] || fail "check of 10,000 bodies took $SECONDS s"
expectMessage '^  9900 more bodies: 59400 particles, 59.4 kg' "bodies in few lines"
[ "$(wc -l <"$work/log")" -le 140 ] || fail "check says $(wc -l <"$work/log") lines"
sed -i 's/0.01, 0.01, 0.06/0.01, 0.03, 0.06/' "$work/many.toml"
head -n 58 "$work/many.toml" >"$work/overlap.toml"
launch 2 check "$work/overlap.toml" >"$work/log" 2>&1
[ $? = 0 ] && fail "bodies that overlap are accepted"
expectMessage "overlap.toml:14:1: error: bodies 'body 0' and 'body 1' overlap: .*; \
'body 0' is at .*overlap.toml:9; " "bodies that overlap"
finish
