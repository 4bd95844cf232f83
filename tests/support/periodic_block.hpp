// SPDX-License-Identifier: Apache-2.0
// A small block of liquid that fills a periodic domain.
#pragma once
#include "tests/support/simulation.hpp"

namespace thaw::test {

inline Scene periodicBlock() {
  Scene s;
  s.spacing = 0.01;
  s.domain.min = {0, 0, 0};
  s.domain.max = {8 * 0.01, 8 * 0.01, 8 * 0.01};
  for (auto& side : s.domain.side) side = {Side::Periodic, Side::Periodic};
  s.domain.gravity = {};
  s.output.every = 0;
  s.numerics.precision = Precision::Double;
  s.materials.emplace_back();
  s.materials[0].soundSpeed = 1e-3;
  addBox(s, s.domain.min, s.domain.max);
  return s;
}

}  // namespace thaw::test
