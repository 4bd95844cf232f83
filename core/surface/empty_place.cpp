#include "core/surface/empty_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/surface/resample.hpp"
#include "core/surface/tangent.hpp"

namespace thaw {
namespace {

constexpr std::size_t directions = 24;

struct Circle {
  std::array<double, directions> cosine, sine;
  Circle() {
    for (std::size_t k = 0; k < directions; k++) {
      const double angle = 2 * 3.14159265358979323846 * static_cast<double>(k) / directions;
      cosine[k] = std::cos(angle);
      sine[k] = std::sin(angle);
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

/// Is p off the solid, past a sharp edge? A face that bends away from the centre's, the surface convex there, has all of the solid behind
/// it; one that bends toward it, all in front.
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
  const double turn = 2 * 3.14159265358979323846;
  if (angle.empty()) return turn;
  std::sort(angle.begin(), angle.end());
  double widest = angle.front() + turn - angle.back();
  for (std::size_t k = 1; k < angle.size(); k++) widest = std::max(widest, angle[k] - angle[k - 1]);
  return widest;
}

Crowding crowdingOf(const Patch& patch, double reach) {
  const Surfels& s = *patch.surfels;
  const std::size_t i = patch.centre;
  const double r = s.radius[i], law = neighboursPerArea * (reach / r) * (reach / r), count = static_cast<double>(patch.rows.size());
  Crowding c;
  c.thin = count < tooFew * law;
  c.closest = count > tooMany * law ? crowdedAtMany : crowdedAt;
  for (const std::uint32_t j : patch.rows) c.crowded = c.crowded || tooClose(s, i, j, c.closest);
  return c;
}

std::optional<SurfacePoint> emptyPlace(const Patch& patch, double distance) {
  static const Circle circle;
  const Vec3d centre = patch.surfels->position[patch.centre];
  std::array<SurfacePoint, directions> around;
  std::array<bool, directions> empty{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < directions; k++) {
    around[k] = pointAround(patch, distance, circle.cosine[k], circle.sine[k]);
    if (covered(patch, around[k], distance)) continue;
    around[k] = ontoSurface(patch, around[k], 2.5 * distance);  // it may have left the surface: at edges, where curvature changes
    const Vec3d d = around[k].position - centre;
    empty[k] = dot(d, d) > 0.81 * distance * distance && dot(d, d) < 1.44 * distance * distance && !covered(patch, around[k], 0.95 * distance) &&
               !pastEdge(patch, around[k], distance);
    count += empty[k];
  }
  if (count == 0) return {};
  std::size_t longest = 0, middle = 0;
  for (std::size_t k = 0; k < directions && count < directions; k++) {
    if (!empty[k] || empty[(k + directions - 1) % directions]) continue;  // not the beginning of an arc
    std::size_t length = 1;
    while (empty[(k + length) % directions]) length++;
    if (length > longest) longest = length, middle = (k + length / 2) % directions;
  }
  return around[middle];
}

}  // namespace thaw
