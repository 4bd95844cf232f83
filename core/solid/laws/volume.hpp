// SPDX-License-Identifier: Apache-2.0
// The volume force of MKN04 (section 3.4), added to any law: energy density k_v/2 (det F - 1)^2.
#pragma once
#include "core/solid/laws/neo_hookean.hpp"

namespace thaw {

/// Energy density (Pa).
template<class T> T volumeEnergy(const Mat3<T>& f, const T& stiffness) {
  const T j = determinant(f) - T(1.0);
  return T(0.5) * stiffness * j * j;
}
/// First Piola stress k_v (det F - 1) cof F, Pa.
template<class T> Mat3<T> volumeStress(const Mat3<T>& f, const T& stiffness) {
  const Mat3<T> c = cofactor(f);
  const T b = stiffness * (dot(f.row[0], c.row[0]) - T(1.0));
  return b * c;
}

}  // namespace thaw
