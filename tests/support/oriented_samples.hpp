// SPDX-License-Identifier: Apache-2.0
// A patch of oriented particles, for tests.
#pragma once
#include "tests/support/simulation.hpp"

namespace thaw::test {

/// 0.5 m square, 0.05 m spacing, undamped; jitter in spacings.
inline Scene patchScene(double jitter) {
  Scene s = test::emptyScene(0.05, {-1, -1, -1}, {1, 1, 1});
  s.end = 1;
  s.oriented.emplace_back();
  OrientedBody& b = s.oriented.back();
  b.name = "patch";
  b.source = OrientedSource::Patch;
  b.width = b.depth = 0.5;
  b.jitter = jitter;
  b.damping = b.spinDamping = 0;
  return s;
}

}  // namespace thaw::test
