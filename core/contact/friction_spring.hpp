// SPDX-License-Identifier: Apache-2.0
// Static friction: a spring along a face with a dashpot (CS79).
#pragma once
#include <algorithm>

#include "core/math/vec3.hpp"

namespace thaw {

struct FrictionLaw {
  double stiffness;  ///< N/m, of the spring
  double rate;       ///< kg/s, of the dashpot
  double bound;      ///< N, Coulomb's limit
};

struct SpringFriction {
  Vec3d shear{};              ///< m, displacement of the spring
  Vec3d spring{}, dashpot{};  ///< N
};

/// Returns the friction at a face with the normal n. moved: m, displacement of the spring after its motion in
/// the step; u: m/s, relative velocity. The spring slips if its force would exceed the bound. The dashpot is
/// limited to the remainder of the bound.
inline SpringFriction springFriction(const FrictionLaw& law, const Vec3d& n, const Vec3d& moved,
                                     const Vec3d& u) {
  SpringFriction f;
  f.shear = moved - n * dot(moved, n);
  const double size = law.stiffness * length(f.shear);
  if (size > law.bound) f.shear = f.shear * (law.bound / size);
  f.spring = f.shear * -law.stiffness;
  const Vec3d slide = u - n * dot(u, n);
  const double speed = length(slide), left = std::max(0.0, law.bound - size);
  if (speed > 0) f.dashpot = slide * -std::min(law.rate, left / speed);
  return f;
}

}  // namespace thaw
