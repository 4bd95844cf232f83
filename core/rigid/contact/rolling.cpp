// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/rolling.hpp"

#include <algorithm>

#include "core/math/sym_eigen.hpp"

namespace thaw {

Rolling rollingOf(const RigidContact& c, const PieceMotion& a, const PieceMotion* b) {
  Rolling r;
  r.arm = c.rolling;
  r.offset = a.spin - (b ? b->spin : c.otherSpin);
  r.radius = std::max(length(c.armA), b ? length(c.armB) : 0.0);
  const SymEigen response = eigenOf(b ? a.inverseInertia + b->inverseInertia : a.inverseInertia);
  r.stiffest = std::max({response.value[0], response.value[1], response.value[2]});
  if (!(r.stiffest > 0)) return r;
  double inverse[3];
  // A straight row of particles has little moment of inertia about its own axis.
  for (int k = 0; k < 3; k++) inverse[k] = 1 / std::max(response.value[k], 1e-9 * r.stiffest);
  r.inverse = withValues(response, inverse);
  r.impulse = c.angularImpulse;
  limitRolling(r, dot(c.impulse, c.normal));
  return r;
}

void limitRolling(Rolling& r, double normalImpulse) {
  const double most = r.arm * std::max(0.0, normalImpulse), size = length(r.impulse);
  if (size > most) r.impulse = (most / size) * r.impulse;
}

Vec3d relaxRolling(Rolling& r, const Vec3d& spin, double normalImpulse) {
  const Vec3d w = r.offset + spin, last = r.impulse;
  r.impulse = last - r.inverse * w;
  if (length(r.impulse) > r.arm * normalImpulse) {  // the contact rolls
    r.impulse = last - w / r.stiffest;
    limitRolling(r, normalImpulse);
  }
  return r.impulse - last;
}

}  // namespace thaw
