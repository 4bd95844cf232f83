// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/density/free_surface.hpp"

#include <algorithm>
#include <cmath>

#include "core/fluid/laws/particle_pressure.hpp"

namespace thaw {
namespace {

/// Asymmetry |sum V grad W| / sum V |grad W| above which a particle is at the free surface: 0.25 in the
/// outermost layer of a lattice.
constexpr double surfaceAsymmetry = 0.19;
/// Distance from a wall, in spacings, within which its normal component is removed.
constexpr double wallLayer = 1.2;
/// Shifting velocity over h times the strain rate, and over sqrt(|p| / rho) under tension, each per
/// concentration gradient.
constexpr double perStrain = 20, perTension = 40;

/// Calls action(row, contacts of the row) for each row that has contacts with walls.
template<class Action> void eachWallRow(const std::vector<WallContact>& list, Action action) {
  for (std::size_t begin = 0, end; begin < list.size(); begin = end) {
    for (end = begin; end < list.size() && list[end].row == list[begin].row;) end++;
    action(list[begin].row, std::span(list).subspan(begin, end - begin));
  }
}

Vec3d alongWalls(Vec3d v, std::span<const WallContact> contacts, double spacing) {
  for (const WallContact& c : contacts)
    if (c.distance < wallLayer * spacing) v -= c.normal * dot(v, c.normal);
  return v;
}

/// Removes the component along the normal of an adjacent solid. Shifting must keep the gap: a few per cent of
/// the displaced volume decide whether the solid floats.
Vec3d alongSolid(Vec3d v, const Vec3d& normal) {
  // length of the normal above which a solid is adjacent; 0.75 in the first layer of a lattice
  constexpr double beside = 0.1;
  const double size = length(normal);
  return size > beside ? v - normal * (dot(v, normal) / (size * size)) : v;
}

/// 1/s, norm of the rate of strain.
double strainRate(const Mat3f& u) {
  const float xy = u.row[0].y + u.row[1].x, yz = u.row[1].z + u.row[2].y, xz = u.row[0].z + u.row[2].x;
  const float diagonal = u.row[0].x * u.row[0].x + u.row[1].y * u.row[1].y + u.row[2].z * u.row[2].z;
  return static_cast<double>(std::sqrt(2 * diagonal + xy * xy + yz * yz + xz * xz));
}

}  // namespace

bool besideSurface(const Continuum& p, std::size_t i) {
  const Vec3f& n = p.surfaceNormal[i];
  return std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}) > 1e-6F;
}

void findFreeSurface(World& w, const StepTools& t) {
  Continuum& p = w.particles;
  const bool corrected = w.modules.corrected;
  const auto asymmetric = [&](std::size_t i, const Vec3d& gradient) {
    return length(gradient) > surfaceAsymmetry * static_cast<double>(p.gradientSize[i]);
  };
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool wet = liquidFraction(p, i) > 0;
    p.atSurface[i] = wet && (corrected ? !eigenvaluesAbove(p.moment[i], static_cast<float>(surfaceMoment))
                                       : asymmetric(i, wide(p.concentrationGradient[i])));
  }
  eachWallRow(t.wallContacts.list, [&](std::size_t i, std::span<const WallContact> contacts) {
    p.atSurface[i] = liquidFraction(p, i) > 0 &&
                     asymmetric(i, alongWalls(wide(p.concentrationGradient[i]), contacts, w.scene.spacing));
  });
}

Vec3d shiftOf(const World& w, const StepTools& t, std::size_t i) {
  const Continuum& p = w.particles;
  if (liquidFraction(p, i) < 1 || p.atSurface[i]) return {};
  const double c = t.liquids[p.material[i]].soundSpeed, compression = p.compression[i];
  double speed = w.scene.numerics.shifting * c;
  if (w.modules.corrected) {
    const double tension = compression < 0 ? c * std::sqrt(-compression) : 0;
    speed = std::min(
        speed, perStrain * w.grid.support * strainRate(p.negativeVelocityGradient[i]) + perTension * tension);
  }
  Vec3d u = wide(p.concentrationGradient[i]) * -speed;
  if (besideSurface(p, i)) {
    const Vec3d out = wide(p.surfaceNormal[i]), inward = out * (1 / length(out));
    u -= inward * std::min(0.0, dot(u, inward));
  }
  return p.solidNormal.active ? alongSolid(u, wide(p.solidNormal[i])) : u;
}

void shiftAlongWalls(World& w, const StepTools& t) {
  Continuum& p = w.particles;
  eachWallRow(t.wallContacts.list, [&](std::size_t i, std::span<const WallContact> contacts) {
    p.shiftingVelocity[i] = alongWalls(p.shiftingVelocity[i], contacts, w.scene.spacing);
  });
}

}  // namespace thaw
