#include "core/geometry/sampling.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/shape_error.hpp"
#include "core/math/hash_random.hpp"

namespace thaw {
namespace {

constexpr double mostPoints = 1099511627776.0;  // 2^40

/// Calls f(i, x) for the points of a row that are inside. Where the surface is farther away than the next points, they are as this one.
template<class F> void forEachInside(const SignedDistance& shape, const SampleLattice& l, std::int64_t row, F&& f) {
  const std::int64_t j = row % l.count[1], k = row / l.count[1];
  const bool gaps = shape.hasGaps();
  for (std::int64_t i = 0; i < l.count[0];) {
    const Vec3d x = l.at(i, j, k);
    std::int64_t same = 1;
    bool in = false;
    if (gaps) {
      in = shape.inside(x);
    } else {
      const double d = shape.distanceWithin(x, 2 * l.spacing);
      in = d < 0;
      same += static_cast<std::int64_t>(std::min(std::abs(d) / l.spacing * (1 - 1e-9), 1e9));
    }
    const std::int64_t end = std::min(l.count[0], i + same);
    if (!in) i = end;
    for (; i < end; i++) f(i, l.at(i, j, k));
  }
}

}  // namespace

SampleLattice sampleLattice(const SignedDistance& shape, double spacing) {
  const Bounds b = shape.bounds();
  SampleLattice l;
  l.spacing = spacing;
  double points = 1;
  for (int a = 0; a < 3; a++) {
    const double size = b.max[a] - b.min[a];
    if (!std::isfinite(b.min[a]) || !std::isfinite(b.max[a])) throw ShapeError("a body of infinite size cannot be filled with particles");
    const double n = std::max(1.0, std::floor(size / spacing + 0.5));
    points *= n;
    if (!(points < mostPoints)) throw ShapeError("a body of this size would need more than 10^12 particles at the scene's spacing");
    l.count[a] = static_cast<std::int64_t>(n);
    l.first[a] = 0.5 * (b.min[a] + b.max[a]) - 0.5 * (n - 1) * spacing;
  }
  return l;
}

SampleRange sampleRange(const SampleLattice& lattice, int rank, int ranks) {
  const std::int64_t rows = lattice.rows(), share = rows / ranks, rest = rows % ranks;
  const auto begin = [&](std::int64_t r) { return share * r + std::min(r, rest); };
  return {begin(rank), begin(rank + 1)};
}

Samples sampleShape(const SignedDistance& shape, const SampleLattice& lattice, SampleRange range) {
  Samples s;
  for (std::int64_t row = range.begin; row < range.end; row++)
    forEachInside(shape, lattice, row, [&](std::int64_t i, const Vec3d& x) {
      s.position.push_back(x);
      s.number.push_back(static_cast<std::uint64_t>(i + lattice.count[0] * row));
    });
  return s;
}

std::int64_t countSamples(const SignedDistance& shape, const SampleLattice& lattice, SampleRange range) {
  std::int64_t n = 0;
  for (std::int64_t row = range.begin; row < range.end; row++) forEachInside(shape, lattice, row, [&](std::int64_t, const Vec3d&) { n++; });
  return n;
}

Vec3d jittered(const Vec3d& point, double amount, double spacing, std::uint64_t seed, std::uint64_t id) {
  Vec3d x = point;
  for (int a = 0; a < 3; a++) x[a] += amount * spacing * (2 * randomUniform(seed, Purpose::Jitter, id, static_cast<std::uint64_t>(a)) - 1);
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
    else depth *= 0.5;  // it went through the middle of something thin
  }
  return at;
}

}  // namespace thaw
