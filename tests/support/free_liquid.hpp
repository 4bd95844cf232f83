// SPDX-License-Identifier: Apache-2.0
// Liquid in a space without walls or gravity.
#pragma once
#include "tests/support/simulation.hpp"

namespace thaw::test {

constexpr double liquidSpacing = 0.01;  // m

inline Scene freeLiquid() {
  Scene s;
  s.spacing = liquidSpacing;
  s.domain.min = {-0.4, -0.4, -0.4};
  s.domain.max = {0.4, 0.4, 0.4};
  s.domain.gravity = {};
  s.output.every = 0;
  s.materials.emplace_back();
  s.materials[0].soundSpeed = 10;
  return s;
}

}  // namespace thaw::test
