// SPDX-License-Identifier: Apache-2.0
#include "core/walls/wall_moments.hpp"

#include <algorithm>
#include <array>

namespace thaw {
namespace {

/// Orthonormal basis of the space spanned by the normals of walls near a particle.
struct NormalBasis {
  std::array<Vec3d, 3> axis;
  std::size_t count = 0;
};

/// Sine of the angle below which two normals count as equal.
constexpr double sameNormal = 0.02;

/// Returns the basis for walls nearer than `reach` (m). In a wedge, normals that are not orthogonal must not
/// be applied one after the other. The second would partly undo the effect of the first.
NormalBasis normalBasis(std::span<const WallContact> contacts, double reach) {
  NormalBasis b;
  for (const WallContact& c : contacts) {
    if (!(c.distance < reach) || b.count == b.axis.size()) continue;
    Vec3d n = c.normal;
    for (std::size_t k = 0; k < b.count; k++) n -= b.axis[k] * dot(n, b.axis[k]);
    if (length(n) > sameNormal) b.axis[b.count++] = normalized(n);
  }
  return b;
}

/// Returns m + n v^T + v n^T.
Sym3d plusPairOf(const Sym3d& m, const Vec3d& n, const Vec3d& v) {
  return {m.xx + 2 * n.x * v.x,         m.yy + 2 * n.y * v.y,         m.zz + 2 * n.z * v.z,
          m.xy + n.x * v.y + n.y * v.x, m.yz + n.y * v.z + n.z * v.y, m.xz + n.x * v.z + n.z * v.x};
}

/// Moment at a wall with the normal n, whose components with n are those of the unit matrix. The sums contain
/// only liquid neighbours. Along the normal, the wall's force balances a uniform pressure.
Sym3d alongWall(const Sym3d& moment, const Vec3d& n) {
  const Vec3d m = moment * n;
  return plusPairOf(moment, n, n * (0.5 * (dot(n, m) + 1)) - m);
}

/// Adds a coupling term to the moment along the wall. The term is `share` times m divided by the liquid's n-n
/// part. Here m is the part of the moment that couples n with the wall's plane. The inverse is still 1 along
/// n. To first order in m, shear along the wall does not change the density. The pressure of liquid with
/// offset layers thus does not resist shear. With hardly any liquid across the wall, m is ignored.
Sym3d withShear(const Sym3d& along, const Sym3d& moment, const Vec3d& n, double share) {
  constexpr double faint = 0.25;  // n-n part; 0.5 in the outermost layer of a lattice
  const Mat3d whole = full(along);
  if (!(determinant(whole) > 0.01)) return along;  // too few neighbours
  const Vec3d m = moment * n;
  const double across = dot(n, m), least = std::max(across, faint);
  const Vec3d coupling = (m - n * across) * (share * std::max(across, 0.0) / (least * least));
  return plusPairOf(along, n, coupling + n * (0.5 * dot(coupling, inverse(whole) * coupling)));
}

}  // namespace

Sym3d alongAllWalls(const Sym3d& moment, std::span<const WallContact> contacts, double h) {
  const NormalBasis normals = normalBasis(contacts, h);
  if (normals.count == 0) return moment;
  const auto nearer = [](const WallContact& a, const WallContact& b) { return a.distance < b.distance; };
  const WallContact& nearest = *std::min_element(contacts.begin(), contacts.end(), nearer);
  double next = h;
  for (const WallContact& c : contacts)
    if (length(cross(c.normal, nearest.normal)) > sameNormal) next = std::min(next, c.distance);
  Sym3d along = moment;
  for (std::size_t k = 0; k < normals.count; k++) along = alongWall(along, normals.axis[k]);
  const double share = std::clamp(2 * next / h - 1, 0.0, 1.0);
  if (share == 0) return along;
  if (normals.count > 1) along = share * alongWall(moment, nearest.normal) + (1 - share) * along;
  return withShear(along, moment, nearest.normal, share);
}

Vec3d alongWalls(Vec3d v, std::span<const WallContact> contacts, double spacing) {
  // distance in spacings within which a wall is adjacent
  constexpr double wallLayer = 1.2;
  const NormalBasis b = normalBasis(contacts, wallLayer * spacing);
  for (std::size_t k = 0; k < b.count; k++) v -= b.axis[k] * dot(v, b.axis[k]);
  return v;
}

}  // namespace thaw
