#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The page lowers the quality of pictures in motion if they are slow, and raises it if they are fast. Fewer
# points and triangles show the same shape.
. "$(dirname "$0")/../support/run.sh"
if ! command -v node >/dev/null; then
  echo "skipped: node is not installed"
  exit 77
fi
node --input-type=module -e '
  import assert from "node:assert/strict";
  const { Pace, QUALITIES } = await import(process.argv[1]);
  const last = QUALITIES.length - 1;

  /// Adds pictures of a machine. costOf(quality): ms. Returns the levels that it used.
  function play(pace, pictures, costOf, begin = 0) {
    const levels = [];
    let now = begin;
    for (let k = 0; k < pictures; k++) {
      const cost = costOf(pace.quality);
      now += Math.max(16, cost);
      pace.add(cost, now);
      levels.push(pace.level);
    }
    return levels;
  }

  const slow = new Pace();
  const lowered = play(slow, 40, () => 250);
  assert.ok(lowered[last - 1] === last, `a very slow machine gets the least at once: ${lowered}`);
  assert.equal(lowered.at(-1), last);

  const quick = new Pace();
  assert.ok(play(quick, 200, () => 5).every((level) => level === 0), "a quick machine keeps the best");

  const between = new Pace();
  const costs = ({ quick: cheap, share }) => (cheap ? 8 * share : 40);
  const levels = play(between, 3000, costs); // 48 s
  const best = levels.filter((level) => level === 0).length;
  assert.ok(best > 0 && best < 30, `the best quality is tried seldom: ${best} pictures of ${levels.length}`);
  assert.ok(levels.every((level) => level <= 1), "no worse quality than needed");

  const once = new Pace();
  play(once, 1, () => 400); // shaders are compiled
  assert.equal(once.level, 1);
  assert.equal(play(once, 600, () => 5).at(-1), 0, "the best quality returns after a single slow picture");
' "$source_dir/viewer/src/scene/pace.js" >"$work/log" 2>&1 ||
  fail "quality in motion: $(tail -n 12 "$work/log")"
node --input-type=module -e '
  import assert from "node:assert/strict";
  const { exposedPoints, coarseTriangles } = await import(process.argv[1]);

  /// Returns the points of a lattice of n^3 points, 1 apart.
  function lattice(n) {
    const data = [];
    for (let k = 0; k < n ** 3; k++) data.push(k % n, Math.floor(k / n) % n, Math.floor(k / n ** 2));
    return { data: Float32Array.from(data), rows: n ** 3 };
  }
  const n = 24,
    block = lattice(n);
  const { index, share } = exposedPoints(block, 0.6);
  assert.equal(share, 1);
  const shown = new Set(index);
  for (let k = 0; k < block.rows; k++) {
    const place = block.data.subarray(3 * k, 3 * k + 3),
      depth = Math.min(...place, n - 1 - Math.max(...place));
    if (depth === 0) assert.ok(shown.has(k), `point ${k} of the outer layer is hidden`);
    if (depth > 4) assert.ok(!shown.has(k), `point ${k} is drawn below ${depth} layers`);
  }
  const large = exposedPoints(lattice(80), 0.6);
  assert.ok(large.share < 1 && large.index.length < 20000, `${large.index.length} points are drawn`);

  // a square sheet of triangles
  const side = 200,
    sheet = [],
    corners = [];
  for (let k = 0; k < side ** 2; k++) sheet.push((k % side) / side, Math.floor(k / side) / side, 0);
  for (let j = 0; j + 1 < side; j++)
    for (let i = 0; i + 1 < side; i++) {
      const a = i + side * j;
      corners.push(a, a + 1, a + side, a + 1, a + side + 1, a + side);
    }
  const position = { data: Float32Array.from(sheet), rows: side ** 2 };
  const coarse = coarseTriangles(position, { data: Uint32Array.from(corners) });
  assert.ok(coarse.length < corners.length / 3, `${coarse.length / 3} triangles are left`);
  let area = 0;
  for (let k = 0; k < coarse.length; k += 3) {
    const at = (v) => sheet.slice(3 * v, 3 * v + 2),
      [[ax, ay], [bx, by], [cx, cy]] = [...coarse.subarray(k, k + 3)].map(at);
    area += ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;
  }
  const whole = ((side - 1) / side) ** 2;
  assert.ok(Math.abs(area / whole - 1) < 0.05, `the sheet has ${area / whole} of its area`);
' "$source_dir/viewer/src/scene/coarse.js" >"$work/log" 2>&1 ||
  fail "coarse shapes: $(tail -n 12 "$work/log")"
finish
