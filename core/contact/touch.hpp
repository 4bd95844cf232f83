// SPDX-License-Identifier: Apache-2.0
// Contact of a sheet vertex or an oriented particle: a spring with dashpot (CS79), a barrier, and Coulomb
// friction. For sheets, forces and energies are per area.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/contact/dashpot.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

struct TouchLaw {
  double rate;         ///< 1/s, of the spring; its stiffness is mass * rate^2
  double mass;         ///< kg/m^2, or kg where forces are N
  double restitution;  ///< 1
  double friction;     ///< 1, Coulomb
  double span;         ///< s, length of the step, in which friction removes at most half of the sliding
                       ///< velocity
  double barrier = 0;  ///< N/m (or N/m^3): adds a force 2 barrier depth^3 / reach^2 to the spring. It stores
                       ///< barrier reach^2 / 2 at full depth and is negligible for light contact
  double reach = 1;    ///< m, depth at which the contact fails
};

struct Touch {
  Vec3d force{};             ///< N/m^2 (or N) on the vertex
  double energy = 0;         ///< J/m^2 (or J), stored
  Vec3d dissipativeForce{};  ///< N/m^2 (or N), dissipative part of force. The loss is -dissipativeForce *
                             ///< velocity, with the velocity after the kick of all forces
  double slope = 0;          ///< N/m^3 (or N/m), stiffness that bounds the step, dashpot included
};

/// Coulomb friction (N/m^2, or N) at normal force `normal` and sliding velocity `slide`.
inline Vec3d frictionOf(const TouchLaw& law, double normal, const Vec3d& slide) {
  const double speed = length(slide);
  if (!(speed > 0) || !(law.friction > 0)) return {};
  return slide * -std::min(law.friction * normal / speed, 0.5 * law.mass / law.span);
}

/// Slope of the force (N/m^3, or N/m) at the largest depth within the next step. depth: m, negative without
/// contact; vn: separation speed, m/s.
inline double slopeAhead(const TouchLaw& law, double depth, double vn) {
  const double ratio = dashpotRatio(law.restitution), k = law.mass * law.rate * law.rate,
               steep = 2 * law.barrier / (law.reach * law.reach);
  const double stiffer = 1 + ratio * (2.2 + 1.1 * ratio);  // for steps in which the dashpot velocity lags by
                                                           // one force evaluation; a fit to the eigenvalues,
                                                           // accurate to 3 %
  const double deeper = std::min(law.reach, depth + std::max(0.0, -vn) * 1.1 * law.span);
  if (!(deeper > 0)) return 0;
  const double root = std::sqrt(k + 3 * steep * deeper * deeper) + std::sqrt(k) * (stiffer - 1);
  return root * root;
}

/// Returns the contact. depth: m, > 0, penetration into the contact thickness; n: outward normal of the other
/// side; v: relative velocity, m/s.
inline Touch touchOf(const TouchLaw& law, double depth, const Vec3d& n, const Vec3d& v) {
  Touch t;
  const double ratio = dashpotRatio(law.restitution), k = law.mass * law.rate * law.rate,
               steep = 2 * law.barrier / (law.reach * law.reach),
               spring = (k + steep * depth * depth) * depth, vn = dot(v, n);
  const double dash = std::max(-2 * ratio * law.mass * law.rate * vn, -spring);  // a contact never pulls
  t.force = n * (spring + dash);
  t.energy = (0.5 * k + 0.25 * steep * depth * depth) * depth * depth;
  t.dissipativeForce = n * dash;
  t.slope = slopeAhead(law, depth, vn);
  const Vec3d rub = frictionOf(law, spring + dash, v - n * vn);
  t.force += rub;
  t.dissipativeForce += rub;
  return t;
}

/// Look-ahead in steps for possible contacts at the end of the next step, which is at most a tenth longer.
inline constexpr double contactLookAhead = 1.5;

/// Rate (1/s) that a step has to resolve during an impact. A contact that begins or ends within a step has a
/// relative energy error of (rate step)^2 / 6. Steps are thus short for fast contacts, and limited by
/// stability alone at rest. speed (m/s): of approach or separation. An eighth of the design speed of the
/// contact (rate * reach / 2) gives steps of a quarter radian.
inline double blowRate(double rate, double reach, double speed) {
  return 4 * rate * speed / (0.0625 * rate * reach);
}

/// Rate of approach (1/s) averaged over a step (s), so that it never overshoots the target.
inline double averaged(double rate, double span) {
  return rate * span > 0 ? -std::expm1(-rate * span) / span : 0;
}

}  // namespace thaw
