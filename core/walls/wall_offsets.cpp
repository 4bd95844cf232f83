// SPDX-License-Identifier: Apache-2.0
#include "core/walls/wall_offsets.hpp"

#include <algorithm>

#include "core/solid/bonds/weight.hpp"

namespace thaw {
namespace {

/// Outward direction of the body's surface at a particle, not normalised.
Vec3d outward(const WallView& w, const Bonds& bonds, std::uint32_t solidIndex) {
  const Column<Vec3d>& x = w.solids.position;
  const double h2 = w.grid.support * w.grid.support;
  const Periods periods = periodsOf(w.grid);
  Vec3d sum{};
  for (int k = 0; k < bonds.capacity; k++) {
    if (!bonds.hasBond(solidIndex, k)) continue;
    const Vec3d d = minimumImage(x[solidIndex] - x[bonds.neighbour[bonds.at(solidIndex, k)]], periods);
    sum += d * std::max(0.0, 1 - dot(d, d) / h2);
  }
  return sum;
}

/// Distance (spacings) at which offsets are determined. It is large enough for this to happen before contact
/// begins, even within substeps.
constexpr double sight = longestSpring + 0.1;

/// Share (1) of the depth that applies if the surface and the wall face each other with this cosine. It is 1
/// on lattice balls, whose surface directions have errors of up to 21 degrees, and 0 at edges of 90 degrees.
double facingShare(double cosine) {
  constexpr double none = 0.72, all = 0.85;
  const double t = std::clamp((cosine - none) / (all - none), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Offset (spacings) of a particle that approaches a wall.
double offsetOf(const WallView& w, const Bonds& bonds, const WallContact& contact) {
  const Continuum& p = w.particles;
  const std::uint32_t i = contact.row;
  const double depth = static_cast<double>(p.contactDepth[i]);
  if (!(depth > 0 && depth < longestSpring) || p.solidIndex[i] == noSolid) return longestSpring;
  if (!keepsSurface(w.scene.materials[p.material[i]])) return longestSpring;
  const Vec3d out = outward(w, bonds, p.solidIndex[i]);
  const double size = length(out);
  if (!(size > 0)) return longestSpring;
  return longestSpring + (depth - longestSpring) * facingShare(-dot(out, contact.normal) / size);
}

}  // namespace

void findWallOffsets(const WallView& w, const WallContacts& contacts, const Bonds& bonds) {
  Continuum& p = w.particles;
  for (auto c = contacts.list.begin(); c != contacts.list.end();) {
    const WallContact* nearest = &*c;
    for (; c != contacts.list.end() && c->row == nearest->row; ++c)
      if (c->distance < nearest->distance) nearest = &*c;
    float& offset = p.wallOffset[nearest->row];
    if (nearest->distance >= sight * w.scene.spacing) offset = 0;
    else if (offset == 0) offset = static_cast<float>(offsetOf(w, bonds, *nearest));
  }
}

}  // namespace thaw
