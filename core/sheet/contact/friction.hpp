// SPDX-License-Identifier: Apache-2.0
// Friction between nearest points at a distance, of a sheet's vertices with each other or with a particle.
// Two opposite forces at a distance exert a torque. Forces of a rigid rotation on the four points balance
// this torque, and this rotation does not count as sliding. Angular momentum is therefore conserved, and the
// power (friction times sliding) is never positive.
#pragma once
#include <array>

#include "core/contact/touch.hpp"
#include "core/math/mat3.hpp"

namespace thaw {

/// Four point masses as a rigid body about their centre of mass.
struct RigidPoints {
  std::array<Vec3d, 4> lever;  ///< m, from the centre of mass
  std::array<double, 4> mass;  ///< kg
  Mat3d inverse;               ///< 1/(kg m^2), inverse inertia
  bool there = false;          ///< false for collinear points
};

inline RigidPoints rigidPointsOf(const std::array<Vec3d, 4>& place, const std::array<double, 4>& mass) {
  constexpr double inLine = 1e-12;  // relative determinant below which points are collinear and get no torque
  RigidPoints t;
  t.mass = mass;
  double all = 0;
  Vec3d centre{};
  for (std::size_t k = 0; k < 4; k++) {
    t.lever[k] = place[k];
    centre += mass[k] * t.lever[k];
    all += mass[k];
  }
  centre = centre / all;
  Mat3d inertia{};
  for (std::size_t k = 0; k < 4; k++) {
    const Vec3d r = t.lever[k] -= centre;
    for (int a = 0; a < 3; a++)
      for (int b = 0; b < 3; b++)
        inertia.row[static_cast<std::size_t>(a)][b] += mass[k] * ((a == b ? dot(r, r) : 0) - r[a] * r[b]);
  }
  const double trace = inertia.row[0][0] + inertia.row[1][1] + inertia.row[2][2];
  t.there = determinant(inertia) > inLine * trace * trace * trace;
  if (t.there) t.inverse = inverse(inertia);
  return t;
}

/// Motion of four points whose two nearest points touch.
struct PointMotion {
  std::array<Vec3d, 4> velocity;  ///< m/s
  std::array<double, 4> share;  ///< barycentric weights of the nearest points, negative for the second body;
                                ///< their sum is 0
  Vec3d apart;                  ///< m, from the second's nearest point to the first's
  Vec3d n;                      ///< unit vector along it
  Vec3d v;                      ///< m/s, its rate
};

/// Returns the friction forces (N) on the four points. share: barycentric weights of the nearest points,
/// negative for the second body, with sum 0. apart: m, from the second body's nearest point to the first's,
/// along n. v: m/s, rate of change of `apart`. normal: N, contact force.
inline std::array<Vec3d, 4> frictionForces(const RigidPoints& t, const PointMotion& motion,
                                           const TouchLaw& law, double normal) {
  const auto& [velocity, share, apart, n, v] = motion;
  Vec3d slide = v - dot(v, n) * n, spin{};
  if (t.there) {
    for (std::size_t k = 0; k < 4; k++) spin += t.mass[k] * cross(t.lever[k], velocity[k]);
    slide -= cross(t.inverse * spin, apart);
  }
  const Vec3d force = frictionOf(law, normal, slide),
              back = t.there ? t.inverse * cross(force, apart) : Vec3d{};
  std::array<Vec3d, 4> forces;
  for (std::size_t k = 0; k < 4; k++) forces[k] = share[k] * force + t.mass[k] * cross(back, t.lever[k]);
  return forces;
}

}  // namespace thaw
