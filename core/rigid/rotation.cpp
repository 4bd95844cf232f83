// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {
namespace {

constexpr int mostTerms = 24;
constexpr double longestAngle = 0.25;  // rad per substep: 24 terms are exact up to rounding

Vec3d overEach(const Vec3d& m, const Vec3d& inertia) {
  return {m.x / inertia.x, m.y / inertia.y, m.z / inertia.z};
}

Quat& operator+=(Quat& a, const Quat& b) {
  a.w += b.w, a.x += b.x, a.y += b.y, a.z += b.z;
  return a;
}

Quat times(double s, const Quat& q) { return {s * q.w, s * q.x, s * q.y, s * q.z}; }

/// Performs one substep. Term k of a series is the k-th Taylor coefficient times dt^k.
Quat substep(const Quat& start, const Vec3d& momentum, const Vec3d& inertia, double dt) {
  Quat q[mostTerms + 1], sum = start;
  Vec3d m[mostTerms + 1], w[mostTerms + 1];
  q[0] = start;
  m[0] = momentum;
  w[0] = overEach(momentum, inertia);
  for (int k = 0; k < mostTerms; k++) {
    Vec3d dm{};
    Quat dq{0, 0, 0, 0};
    for (int j = 0; j <= k; j++) {
      const Vec3d& rate = w[k - j];
      dm += cross(m[j], rate);
      dq += q[j] * Quat{0, rate.x, rate.y, rate.z};
    }
    m[k + 1] = dm * (dt / (k + 1));
    w[k + 1] = overEach(m[k + 1], inertia);
    q[k + 1] = times(0.5 * dt / (k + 1), dq);
    sum += q[k + 1];
    const double size = std::abs(q[k + 1].w) + std::abs(q[k + 1].x) + std::abs(q[k + 1].y) +
                        std::abs(q[k + 1].z);
    // All odd or all even terms may vanish, so the test uses two terms.
    const double before = std::abs(q[k].w) + std::abs(q[k].x) + std::abs(q[k].y) + std::abs(q[k].z);
    if (k > 0 && size < 1e-19 && before < 1e-18) break;
  }
  return unitQuat(sum);
}

}  // namespace

Quat rotateFreely(const Quat& orientation, const Vec3d& angularMomentum, const Vec3d& inertia, double dt) {
  const auto inBody = [&](const Quat& q) { return rotated(conjugate(q), angularMomentum); };
  const Vec3d m = inBody(orientation);
  const double twiceEnergy = dot(m, overEach(m, inertia));
  const double least = std::min({inertia.x, inertia.y, inertia.z});
  const double angle = std::sqrt(twiceEnergy / least) * std::abs(dt);  // upper bound of the rotation angle
                                                                       // over dt
  if (!(angle > 0)) return orientation;
  const int substeps = static_cast<int>(std::min(std::ceil(angle / longestAngle), 1e6));
  Quat q = orientation;
  for (int k = 0; k < substeps; k++) q = substep(q, inBody(q), inertia, dt / substeps);
  return q;
}

Quat quatOf(const Vec3d& x, const Vec3d& y, const Vec3d& z) {
  // Shepperd's method computes the largest of the four components first.
  const double trace = x.x + y.y + z.z;
  Quat q;
  if (trace >= std::max({x.x, y.y, z.z})) {
    q = {1 + trace, y.z - z.y, z.x - x.z, x.y - y.x};
  } else if (x.x >= y.y && x.x >= z.z) {
    q = {y.z - z.y, 1 + x.x - y.y - z.z, x.y + y.x, x.z + z.x};
  } else if (y.y >= z.z) {
    q = {z.x - x.z, x.y + y.x, 1 - x.x + y.y - z.z, y.z + z.y};
  } else {
    q = {x.y - y.x, x.z + z.x, y.z + z.y, 1 - x.x - y.y + z.z};
  }
  return unitQuat(q);
}

}  // namespace thaw
