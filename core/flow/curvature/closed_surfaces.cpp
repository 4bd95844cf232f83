// SPDX-License-Identifier: Apache-2.0
#include "core/flow/curvature/closed_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/flow/curvature/surface_loops.hpp"
#include "core/halo/exchange.hpp"
#include "core/halo/spread_labels.hpp"
#include "core/rigid/contact/fixed_sum.hpp"
#include "core/rigid/piece_sums.hpp"
#include "core/terms/outside_forces.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {
namespace {

/// Number of integer sums per surface: area, three components of the force, and the number of particles where
/// the surface is open. Integer sums do not depend on the order.
constexpr std::size_t wordsOfSurface = 5;

/// Bits of the largest summand. Sums over up to 2^26 particles do not overflow. Each summand has an error of
/// 2^-37 of the largest summand.
constexpr int summandBits = 36;

/// Surfaces with particles on this rank.
struct Surfaces {
  std::vector<std::uint64_t> label;  ///< 1 + the smallest id of its particles, ascending
  std::vector<std::uint32_t> of;     ///< index of the surface of each owned row at a surface
};

/// Labels the connected particles at the surface of all ranks.
Surfaces findSurfaces(const CurvatureContext& x) {
  Continuum& p = x.world.particles;
  for (std::size_t i = 0; i < p.owned; i++) p.setLabel[i] = weightOf(p, i) > 0 ? p.id[i] + 1 : noSet;
  refresh(x.halo, p, ColumnList{&p.setLabel}).wait();
  DisjointSets sets(p.size());
  eachAtSurface(x, [&](std::uint32_t i, std::size_t g, std::size_t l) {
    eachNeighbour(x, i, g, l, [&](std::uint32_t j, const Vec3d&) { sets.join(i, j); });
  });
  spreadLabels({p.setLabel.data(), p.size()}, p.owned, sets, x.all,
               [&] { refresh(x.halo, p, ColumnList{&p.setLabel}).wait(); });
  Surfaces s{{}, std::vector<std::uint32_t>(p.owned)};
  std::copy_if(p.setLabel.data(), p.setLabel.data() + p.owned, std::back_inserter(s.label),
               [](std::uint64_t label) { return label != noSet; });
  std::sort(s.label.begin(), s.label.end());
  s.label.erase(std::unique(s.label.begin(), s.label.end()), s.label.end());
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.setLabel[i] != noSet)
      s.of[i] = static_cast<std::uint32_t>(std::lower_bound(s.label.begin(), s.label.end(), p.setLabel[i]) -
                                           s.label.begin());
  return s;
}

/// Units of areas and forces in the sums. They are powers of two, so products with them are exact.
struct Units {
  double area, force;
};

Units commonUnits(const CurvatureContext& x, const std::vector<Vec3d>& force) {
  double most[2] = {0, 0};
  const Continuum& p = x.world.particles;
  for (std::uint32_t i = 0; i < p.owned; i++) {
    most[0] = std::max(most[0], weightOf(p, i));
    most[1] = std::max({most[1], std::abs(force[i].x), std::abs(force[i].y), std::abs(force[i].z)});
  }
  x.all.maximum(most);
  const auto unit = [](double value) {
    return value > 0 && std::isfinite(value) ? FixedUnit::forScale(value, summandBits).unit : 1;
  };
  return {unit(most[0]), unit(most[1])};
}

/// Returns true if the surface ends near a row. It ends at a wall, a solid, or a clamped or sleeping
/// particle, which take up momentum.
bool surfaceEndsNear(const CurvatureContext& x, std::uint32_t i, std::size_t g, std::size_t l) {
  if (!isFree(x.world.particles, i)) return true;
  for (const WallContact& c : contactsOf(x.contacts, i))
    if (c.distance < x.world.grid.support) return true;
  return hasSolidNeighbour(x, g, l);
}

}  // namespace

void balanceClosedSurfaces(const CurvatureContext& x, std::vector<Vec3d>& force) {
  const Continuum& p = x.world.particles;
  const Surfaces surfaces = findSurfaces(x);
  const Units units = commonUnits(x, force);
  std::vector<std::int64_t> sums(surfaces.label.size() * wordsOfSurface, 0);
  eachAtSurface(x, [&](std::uint32_t i, std::size_t g, std::size_t l) {
    std::int64_t* const sum = &sums[surfaces.of[i] * wordsOfSurface];
    const bool finite = std::isfinite(dot(force[i], force[i])) && std::isfinite(weightOf(p, i));
    sum[4] += !finite || surfaceEndsNear(x, i, g, l) ? 1 : 0;
    if (!finite) return;
    sum[0] += std::llround(weightOf(p, i) / units.area);
    for (int axis = 0; axis < 3; axis++) sum[1 + axis] += std::llround(force[i][axis] / units.force);
  });
  RankPieceExchange(x.all, surfaces.label, nullptr).sum(sums, wordsOfSurface);
  eachAtSurface(x, [&](std::uint32_t i, std::size_t, std::size_t) {
    const std::int64_t* const sum = &sums[surfaces.of[i] * wordsOfSurface];
    if (sum[4] > 0 || sum[0] == 0) return;
    const double share = weightOf(p, i) / (static_cast<double>(sum[0]) * units.area) * units.force;
    force[i] -= Vec3d{static_cast<double>(sum[1]), static_cast<double>(sum[2]), static_cast<double>(sum[3])} *
                share;
  });
}

}  // namespace thaw
