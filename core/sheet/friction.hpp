// Friction between nearest points that are apart, of a sheet's vertices with each other or with a particle.
// Two opposite forces there would be a torque out of nothing: the four bodies take it back as a rigid body,
// and what they turn as one is no sliding. So angular momentum is kept, and the power is friction times
// sliding: never a gain.
#pragma once
#include <array>

#include "core/contact/touch.hpp"
#include "core/math/mat3.hpp"

namespace thaw {

/// Four points of mass as a rigid body, about their centre of mass.
struct Turning {
  std::array<Vec3d, 4> lever;  ///< m
  std::array<double, 4> mass;  ///< kg
  Mat3d inverse;               ///< 1/(kg m^2), of the inertia
  bool there = false;          ///< not of what is in a line
};

inline Turning turningOf(const std::array<Vec3d, 4>& place, const std::array<double, 4>& mass) {
  constexpr double inLine = 1e-12;  // of the inertia of points that are: they cannot take a torque
  Turning t;
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

/// Forces (N) on the four. share: of the nearest points, negative for the second body, in all 0; apart (m):
/// from the second's nearest point to the first's, along n; v (m/s): how fast that changes; normal (N): what
/// presses them together.
inline std::array<Vec3d, 4> rub(const Turning& t, const std::array<Vec3d, 4>& velocity,
                                const std::array<double, 4>& share, const Vec3d& apart, const Vec3d& n,
                                const Vec3d& v, const TouchLaw& law, double normal) {
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
