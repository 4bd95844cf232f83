// SPDX-License-Identifier: Apache-2.0
#include "core/solid/elasticity/elastic_records.hpp"

#include <bit>

namespace thaw {

namespace {

// Returns the nearest integer modulo 2^32 for |x| < 2^51. It is in the low bits of the mantissa after the
// addition of 1.5 * 2^52.
std::uint32_t fixedPoint(double x) {
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(x + fixedPointMagic));
}

template<class Real>
void packMotionOf(AlignedVector<Real>& records, const Solids& solids, std::size_t first, std::size_t last) {
  const std::size_t values = 4 * solids.size();
  if (records.size() < values) records.resize(values + values / 16, 0);
  for (std::size_t s = first; s < last; s++) {
    for (std::size_t a = 0; a < 3; a++)
      records[4 * s + a] = static_cast<Real>(solids.velocity[s][static_cast<int>(a)]);
    records[4 * s + 3] = static_cast<Real>(solids.drag[s]);
  }
}

}  // namespace

void packReferences(const ElasticWork& work, Solids& solids, std::size_t first, std::size_t last) {
  if (!solids.reference.active) return;
  const double scale = fixedUnitsPerSupport / work.support;
  for (std::size_t s = first; s < last; s++)
    for (int a = 0; a < 3; a++) {
      if (work.precision == Precision::Single)
        solids.end[s].reference[a] = std::bit_cast<float>(fixedPoint(solids.reference[s][a] * scale));
      else solids.endDouble[s].reference[a] = solids.reference[s][a];
    }
}

namespace {

template<bool periodic, bool single>
void packPlacesOf(const ElasticWork& work, Solids& solids, std::size_t first, std::size_t last) {
  const double unit = work.support / fixedUnitsPerSupport, scale = fixedUnitsPerSupport / work.support;
  std::uint32_t units[3];  // length of a period, as in Places
  for (int a = 0; a < 3; a++)
    units[a] = static_cast<std::uint32_t>(static_cast<std::uint64_t>(work.periods.length[a] / unit + 0.5));
  const auto periodsAway = [&](std::size_t s, int a) {
    const double period = work.periods.length[a], d = solids.position[s][a] - solids.reference[s][a];
    return !(period > 0) ? 0 : d > period / 2 ? 1 : d < -period / 2 ? -1 : 0;
  };
  const Vec3d* const position = solids.position.data();
  BondEnd<float>* const end = solids.end.data();
  for (std::size_t s = first; s < last; s++)
    for (int a = 0; a < 3; a++) {
      if constexpr (single) {
        std::uint32_t u = fixedPoint(position[s][a] * scale) -
                          std::bit_cast<std::uint32_t>(end[s].reference[a]);
        if constexpr (periodic) u -= static_cast<std::uint32_t>(periodsAway(s, a)) * units[a];
        end[s].displacement[a] = std::bit_cast<float>(u);
      } else {
        double& u = solids.endDouble[s].displacement[a];
        u = position[s][a] - solids.endDouble[s].reference[a];
        if constexpr (periodic) u -= static_cast<double>(periodsAway(s, a)) * work.periods.length[a];
      }
    }
}
template<bool periodic>
void packPlacesIn(const ElasticWork& work, Solids& solids, std::size_t first, std::size_t last) {
  work.precision == Precision::Single ? packPlacesOf<periodic, true>(work, solids, first, last)
                                      : packPlacesOf<periodic, false>(work, solids, first, last);
}

}  // namespace

/// Displacements use the nearest image of the position. In a rotating body across a periodic side, particles
/// cross the side in both directions. Thus x - X of neighbours may differ by two periods, of which Places
/// removes only one. If bonds have vectors, positions are packed instead, which differ by at most one period.
void packPositions(const ElasticWork& work, Solids& solids, std::size_t first, std::size_t last) {
  if (work.periodic && solids.reference.active) packPlacesIn<true>(work, solids, first, last);
  else packPlacesIn<false>(work, solids, first, last);
}

void packVelocityDrag(ElasticWork& work, const Solids& solids, std::size_t first, std::size_t last) {
  if (!work.damping) return;
  if (work.precision == Precision::Single) packMotionOf(work.velocityDrag, solids, first, last);
  else packMotionOf(work.velocityDragDouble, solids, first, last);
}

}  // namespace thaw
