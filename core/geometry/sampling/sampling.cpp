// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/sampling/sampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/hash_random.hpp"

namespace thaw {
namespace {

constexpr std::size_t pointsAtOnce = 256;  // points of a row per batch

}  // namespace

SampleRange sampleRange(const SampleLattice& lattice, int rank, int ranks) {
  const std::int64_t rows = lattice.rows(), share = rows / ranks, rest = rows % ranks;
  const auto begin = [&](std::int64_t r) { return share * r + std::min(r, rest); };
  return {begin(rank), begin(rank + 1)};
}

std::vector<std::int64_t> insideOfRow(const SignedDistance& shape, const SampleLattice& l, std::int64_t row,
                                      KnownSides& known) {
  const std::int64_t j = row % l.count[1], k = row / l.count[1];
  std::array<Vec3d, pointsAtOnce> points;
  std::array<std::uint8_t, pointsAtOnce> in;
  std::vector<std::int64_t> inside;
  for (std::int64_t first = 0; first < l.count[0]; first += static_cast<std::int64_t>(pointsAtOnce)) {
    const auto n = static_cast<std::size_t>(
        std::min(l.count[0] - first, static_cast<std::int64_t>(pointsAtOnce)));
    for (std::size_t i = 0; i < n; i++) points[i] = l.at(first + static_cast<std::int64_t>(i), j, k);
    shape.insideAlong({points.data(), n}, {in.data(), n}, known);
    for (std::size_t i = 0; i < n; i++)
      if (in[i]) inside.push_back(first + static_cast<std::int64_t>(i));
  }
  return inside;
}

Vec3d jittered(const Vec3d& point, double amount, double spacing, std::uint64_t seed, std::uint64_t id) {
  Vec3d x = point;
  for (int a = 0; a < 3; a++)
    x[a] += amount * spacing *
            (2 * randomUniform(seed, Purpose::Jitter, id, static_cast<std::uint64_t>(a)) - 1);
  return x;
}

Vec3d pullInside(const SignedDistance& shape, const Vec3d& x, double margin) {
  constexpr int mostSteps = 24;
  Vec3d at = x, gradient;
  double d = shape.distance(at, &gradient), depth = margin;
  for (int step = 0; step < mostSteps && -d < depth; step++) {
    const Vec3d next = at - gradient * ((d + depth) * (1 + 1e-9));
    Vec3d nextGradient;
    const double nextD = shape.distance(next, &nextGradient);
    if (nextD < d) at = next, d = nextD, gradient = nextGradient;
    else depth *= 0.5;  // the step passed the middle of a thin part
  }
  return at;
}

}  // namespace thaw
