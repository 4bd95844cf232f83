// SPDX-License-Identifier: Apache-2.0
// Stiffness of a solid in contacts.
#pragma once
#include <algorithm>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns the modulus (Pa) of contact springs at a liquid fraction: Young's modulus plus the volume
/// stiffness of the solid part. Without the latter a contact would be softer than the body that it stops.
inline double contactModulus(const Material& m, double liquidFraction) {
  return m.young.at(liquidFraction) + (1 - liquidFraction) * m.volumeStiffness;
}

/// Returns the largest modulus (Pa) of contactModulus at any liquid fraction.
inline double largestContactModulus(const Material& m) {
  return std::max(m.young.solid + m.volumeStiffness, m.young.liquid);
}

}  // namespace thaw
