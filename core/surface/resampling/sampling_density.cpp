// SPDX-License-Identifier: Apache-2.0
#include "core/surface/resampling/sampling_density.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/math/tangent.hpp"
#include "core/surface/kernels/surface_kernels.hpp"
#include "core/surface/resampling/resample.hpp"

namespace thaw {
namespace {

constexpr std::size_t directions = circlePlaces;

struct Circle {
  std::array<double, directions> cosine, sine;
  std::array<float, directions> cosineF, sineF;
  Circle() {
    for (std::size_t k = 0; k < directions; k++) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / directions;
      cosine[k] = std::cos(angle);
      sine[k] = std::sin(angle);
      cosineF[k] = static_cast<float>(cosine[k]), sineF[k] = static_cast<float>(sine[k]);
    }
  }
};

bool covered(const Patch& patch, const SurfacePoint& p, double distance) {
  const Surfels& s = *patch.surfels;
  for (const std::uint32_t j : patch.rows) {
    const Vec3d d = p.position - s.position[j];
    if (dot(d, d) < distance * distance && dot(p.normal, s.normal[j]) > oneSide) return true;
  }
  return false;
}

/// Returns 1 for directions whose point (pointAround) no surfel of the patch covers, else 0. Lengths are in
/// units of `distance`. All directions are tested at once, since most surfels have no open direction.
std::array<float, directions> openDirections(Patch& patch, double distance, const Circle& circle) {
  const Surfels& s = *patch.surfels;
  const Vec3d centre = s.position[patch.centre], n = s.normal[patch.centre], u = s.tangent[patch.centre],
              v = cross(n, u);
  CirclePlaces at{circle.cosineF.data(), circle.sineF.data(), {}, {}, {}, {}, static_cast<float>(oneSide)};
  for (int a = 0; a < 3; a++) {
    at.normal[a] = static_cast<float>(n[a]), at.tangent[a] = static_cast<float>(u[a]),
    at.across[a] = static_cast<float>(v[a]);
    at.curvature[a] = static_cast<float>(patch.curvature[a] * distance);
  }
  const double perDistance = 1 / distance;
  patch.seen.resize(6 * patch.rows.size());
  float* disc = patch.seen.data();
  for (const std::uint32_t j : patch.rows) {
    const Vec3d d = perDistance * (s.position[j] - centre), m = s.normal[j];
    if (dot(d, d) > 4.1) continue;
    for (const double v : {d.x, d.y, d.z, m.x, m.y, m.z}) *disc++ = static_cast<float>(v);
  }
  std::array<float, directions> open;
  bestSurfaceKernels().openPlaces(at, patch.seen.data(),
                                  static_cast<std::size_t>(disc - patch.seen.data()) / 6, open.data());
  return open;
}

/// Returns whether p lies beyond a sharp edge, off the solid. At a convex edge, the solid lies behind the
/// neighbouring face. At a concave edge, it lies in front of that face.
bool pastEdge(const Patch& patch, const SurfacePoint& p, double distance) {
  const Surfels& s = *patch.surfels;
  const Vec3d centre = s.position[patch.centre], normal = s.normal[patch.centre];
  for (const std::uint32_t j : patch.rows) {
    const Vec3d d = p.position - s.position[j];
    if (dot(s.normal[j], normal) > 0.7 || dot(d, d) > 2.25 * distance * distance) continue;
    const double ahead = dot(s.normal[j], d), convex = dot(s.normal[j] - normal, s.position[j] - centre);
    if (convex > 0 ? ahead > 0.15 * distance : ahead < -0.15 * distance) return true;
  }
  return false;
}

/// Returns whether p is outside all discs and far from their planes. Between faces that meet at an edge, the
/// mean of their planes (projectToPatch) may lie deep below both. Births there would continue as a second
/// sheet behind the surface. Only surfels with mesh detail are tested, because the edges of thin grown plates
/// are rounder than their discs.
bool offAllDiscs(const Patch& patch, const SurfacePoint& p, double distance) {
  constexpr double highest = 0.4;
  const Surfels& s = *patch.surfels;
  if (s.detail[patch.centre] < 0.5f) return false;
  const auto on = [&](std::size_t j) {
    const Vec3d d = p.position - s.position[j];
    return dot(d, d) < 2.25 * distance * distance && std::abs(dot(d, s.normal[j])) < highest * distance;
  };
  return !on(patch.centre) && std::none_of(patch.rows.begin(), patch.rows.end(), on);
}

}  // namespace

double widestGap(const Patch& patch, const SurfacePoint& p, double reach) {
  const Surfels& s = *patch.surfels;
  const Vec3d u = anyTangent(p.normal), v = cross(p.normal, u);
  std::vector<double> angle;
  const auto look = [&](std::size_t j) {
    const Vec3d d = s.position[j] - p.position;
    if (dot(d, d) < reach * reach) angle.push_back(std::atan2(dot(d, v), dot(d, u)));
  };
  look(patch.centre);
  for (const std::uint32_t j : patch.rows) look(j);
  const double turn = 2 * std::numbers::pi;
  if (angle.empty()) return turn;
  std::sort(angle.begin(), angle.end());
  double widest = angle.front() + turn - angle.back();
  for (std::size_t k = 1; k < angle.size(); k++) widest = std::max(widest, angle[k] - angle[k - 1]);
  return widest;
}

SamplingDensity samplingDensityOf(const Patch& patch, double reach) {
  const Surfels& s = *patch.surfels;
  const std::size_t i = patch.centre;
  const double r = s.radius[i], law = neighboursPerArea * (reach / r) * (reach / r),
               count = static_cast<double>(patch.rows.size());
  SamplingDensity c;
  c.thin = count < tooFew * law;
  c.closest = hasReference(s, i) ? crowdedAtSolid : count > tooMany * law ? crowdedAtMany : crowdedAt;
  for (const std::uint32_t j : patch.rows) c.crowded = c.crowded || tooClose(s, i, j, c.closest);
  return c;
}

std::optional<SurfacePoint> uncoveredPoint(Patch& patch, double distance) {
  static const Circle circle;
  const Vec3d centre = patch.surfels->position[patch.centre];
  const std::array<float, directions> open = openDirections(patch, distance, circle);
  if (std::none_of(open.begin(), open.end(), [](float o) { return o > 0; })) return {};
  std::array<SurfacePoint, directions> around;
  std::array<bool, directions> empty{};
  std::size_t count = 0;
  std::array<std::size_t, 8> of;
  std::array<SurfacePoint, 8> some;
  std::size_t n = 0;
  const auto look = [&] {
    // Points may have left the surface at edges, where the curvature changes.
    projectToPatch(patch, some.data(), n, 2.5 * distance);
    for (std::size_t m = 0; m < n; m++) {
      const SurfacePoint& p = around[of[m]] = some[m];
      const Vec3d d = p.position - centre;
      empty[of[m]] = dot(d, d) > 0.81 * distance * distance && dot(d, d) < 1.44 * distance * distance &&
                     !covered(patch, p, 0.95 * distance) && !pastEdge(patch, p, distance) &&
                     !offAllDiscs(patch, p, distance);
      count += empty[of[m]];
    }
    n = 0;
  };
  for (std::size_t k = 0; k < directions; k++) {
    if (!(open[k] > 0)) continue;
    of[n] = k;
    some[n] = pointAround(patch, distance, circle.cosine[k], circle.sine[k]);
    if (++n == some.size()) look();
  }
  if (n > 0) look();
  if (count == 0) return {};
  std::size_t longest = 0, middle = 0;
  for (std::size_t k = 0; k < directions && count < directions; k++) {
    // skipped: not the beginning of an arc
    if (!empty[k] || empty[(k + directions - 1) % directions]) continue;
    std::size_t length = 1;
    while (empty[(k + length) % directions]) length++;
    if (length > longest) longest = length, middle = (k + length / 2) % directions;
  }
  return around[middle];
}

}  // namespace thaw
