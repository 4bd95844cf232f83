// SPDX-License-Identifier: Apache-2.0
// Particles that leave through open sides.
#pragma once
#include <cstdint>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

/// A particle that leaves in this step.
struct Leaver {
  std::uint64_t id = 0;
  Vec3d position{};             ///< m
  double volume = 0;            ///< h^3
  double rootTension = 0;       ///< (N/m)^1/2
  std::vector<double> records;  ///< four values for each pair force of an extension
};

}  // namespace thaw
