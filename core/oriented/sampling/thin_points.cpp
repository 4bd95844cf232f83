// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/sampling/thin_points.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/geometry/trees/point_tree.hpp"
#include "core/math/hash_random.hpp"
#include "core/oriented/data/oriented.hpp"
#include "core/oriented/interpolation/interpolant.hpp"

namespace thaw {
namespace {

// Largest distance of a surface position from evenly spread points, over the points' mean nearest distance.
constexpr double evenReach = 0.95;
constexpr double chosenByError = 0.33;  // fraction of the kept points
constexpr int rounds = 4;

/// Returns about `wanted` points in ascending order: Poisson discs in hashed order, with a radius found by
/// bisection.
std::vector<std::uint32_t> evenly(const SampledPoints& m, const PointTree& tree, std::size_t wanted,
                                  std::uint64_t seed) {
  std::vector<std::uint32_t> order(m.places.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<std::uint64_t> rank;
  for (std::size_t k = 0; k < order.size(); k++)
    rank.push_back(randomBits(seed, Purpose::OrientedSample, k, 1));
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return rank[a] < rank[b]; });
  // kept: points selected before
  const auto keptAt = [&](double apart, std::vector<std::uint32_t> kept) {
    std::vector<std::uint8_t> covered(m.places.size(), 0);
    const auto cover = [&](std::uint32_t k) {
      covered[k] = 1;
      // thin bodies have two sides
      for (const std::uint32_t q : tree.within(m.places[k], apart))
        covered[q] |= dot(m.normals[k], m.normals[q]) > 0;
    };
    for (const std::uint32_t k : kept) cover(k);
    for (const std::uint32_t k : order) {
      if (covered[k]) continue;
      kept.push_back(k);
      cover(k);
    }
    return kept;
  };
  double low = 0, high = 1e-3;
  for (const Vec3d& x : m.places) high = std::max(high, length(x - m.places[0]));
  std::vector<std::uint32_t> kept = keptAt(high, {}), these;
  for (int k = 0; k < 40 && kept.size() != wanted; k++) {
    const double apart = 0.5 * (low + high);
    these = keptAt(apart, {});
    (these.size() > wanted ? low : high) = apart;
    if (these.size() <= wanted) kept = these;
  }
  // a lattice allows only certain counts, so the first points of the next smaller radius fill up the list
  if (kept.size() < wanted) kept = keptAt(low, std::move(kept));
  if (kept.size() > wanted) kept.resize(wanted);
  std::sort(kept.begin(), kept.end());
  return kept;
}

PointInterpolant interpolantThrough(const SampledPoints& m, const std::vector<std::uint32_t>& kept) {
  PointInterpolant g;
  for (const std::uint32_t k : kept) {
    g.points.push_back(m.places[k]);
    g.normals.push_back(m.normals[k]);
  }
  buildInterpolant(g);
  return g;
}

}  // namespace

SampledPoints thinPoints(const SampledPoints& m, double share, std::uint64_t seed) {
  const PointTree tree(m.places);
  const auto wanted = static_cast<std::size_t>(
      std::ceil(share * static_cast<double>(m.places.size()) - 1e-9));
  std::vector<std::uint32_t> kept = evenly(
      m, tree, wanted - static_cast<std::size_t>(chosenByError * static_cast<double>(wanted)), seed);
  SampledPoints thin;
  for (int round = rounds; round > 0 && kept.size() < wanted; round--) {
    const PointInterpolant given = interpolantThrough(m, kept);
    if (round == rounds) thin.reach = evenReach * given.apart;
    std::vector<std::pair<double, std::uint32_t>> far;
    for (std::uint32_t k = 0; k < m.places.size(); k++) {
      Vec3d x = m.places[k], n = m.normals[k];
      far.push_back({projectOnInterpolant(given, x, n) && dot(n, m.normals[k]) > 0 ? length(x - m.places[k])
                                                                                   : given.apart,
                     k});
    }
    std::sort(far.begin(), far.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    // points near a new one are skipped until the next round
    std::vector<std::uint8_t> waits(m.places.size(), 0);
    std::size_t more = (wanted - kept.size() + static_cast<std::size_t>(round) - 1) /
                       static_cast<std::size_t>(round);
    for (const std::uint32_t k : kept) waits[k] = 1;
    for (const auto& [error, k] : far) {
      if (more == 0) break;
      if (waits[k]) continue;
      kept.push_back(k);
      more--;
      for (const std::uint32_t q : tree.within(m.places[k], 0.5 * given.apart))
        waits[q] |= dot(m.normals[k], m.normals[q]) > 0;
    }
    std::sort(kept.begin(), kept.end());
  }
  if (thin.reach == 0) thin.reach = evenReach * interpolantThrough(m, kept).apart;
  for (const std::uint32_t k : kept)
    addPoint(thin, m.places[k], m.normals[k], fixedPosition | fixedOrientation);
  return thin;
}

}  // namespace thaw
