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

/// 1 for directions whose point (pointAround) no surfel of the patch covers, else 0. All directions at once, in units of `distance`: most surfels have none.
std::array<float, directions> openDirections(const Patch& patch, double distance, const Circle& circle) {
  const Surfels& s = *patch.surfels;
  const Vec3d centre = s.position[patch.centre], n = s.normal[patch.centre], u = s.tangent[patch.centre], v = cross(n, u);
  std::array<float, directions> x, y, z, nx, ny, nz, open;
  const float ss = static_cast<float>(patch.curvature[0] * distance), st = static_cast<float>(patch.curvature[1] * distance), tt = static_cast<float>(patch.curvature[2] * distance);
  const std::array<float, 3> fn{static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)}, fu{static_cast<float>(u.x), static_cast<float>(u.y), static_cast<float>(u.z)},
      fv{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  for (std::size_t k = 0; k < directions; k++) {
    const float c = static_cast<float>(circle.cosine[k]), d = static_cast<float>(circle.sine[k]), curved = std::min(1.2f, std::max(-1.2f, c * c * ss + 2 * c * d * st + d * d * tt));
    const float sink = 0.5f * curved, flat = std::sqrt(1 - sink * sink), up = 1 - curved * sink, a = flat * (c * ss + d * st), b = flat * (c * st + d * tt);
    const float alongU = flat * c, alongV = flat * d, size = 1 / std::sqrt(up * up + a * a + b * b);
    x[k] = alongU * fu[0] + alongV * fv[0] - sink * fn[0];
    y[k] = alongU * fu[1] + alongV * fv[1] - sink * fn[1];
    z[k] = alongU * fu[2] + alongV * fv[2] - sink * fn[2];
    nx[k] = size * (up * fn[0] + a * fu[0] + b * fv[0]);
    ny[k] = size * (up * fn[1] + a * fu[1] + b * fv[1]);
    nz[k] = size * (up * fn[2] + a * fu[2] + b * fv[2]);
    open[k] = 1;
  }
  const double perDistance = 1 / distance;
  const float side = static_cast<float>(oneSide);
  for (const std::uint32_t j : patch.rows) {
    const Vec3d d = perDistance * (s.position[j] - centre), m = s.normal[j];
    if (dot(d, d) > 4.1) continue;
    const float dx = static_cast<float>(d.x), dy = static_cast<float>(d.y), dz = static_cast<float>(d.z), mx = static_cast<float>(m.x), my = static_cast<float>(m.y), mz = static_cast<float>(m.z);
    for (std::size_t k = 0; k < directions; k++) {
      const float ex = x[k] - dx, ey = y[k] - dy, ez = z[k] - dz;
      const float off = ex * ex + ey * ey + ez * ez < 1 ? 0.0f : 1.0f, other = nx[k] * mx + ny[k] * my + nz[k] * mz > side ? 0.0f : 1.0f;
      open[k] *= std::max(off, other);
    }
  }
  return open;
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
  c.closest = follows(s, i) ? crowdedAtSolid : count > tooMany * law ? crowdedAtMany : crowdedAt;
  for (const std::uint32_t j : patch.rows) c.crowded = c.crowded || tooClose(s, i, j, c.closest);
  return c;
}

std::optional<SurfacePoint> emptyPlace(const Patch& patch, double distance) {
  static const Circle circle;
  const Vec3d centre = patch.surfels->position[patch.centre];
  const std::array<float, directions> open = openDirections(patch, distance, circle);
  if (std::none_of(open.begin(), open.end(), [](float o) { return o > 0; })) return {};
  std::array<SurfacePoint, directions> around;
  std::array<bool, directions> empty{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < directions; k++) {
    if (!(open[k] > 0)) continue;
    around[k] = pointAround(patch, distance, circle.cosine[k], circle.sine[k]);
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
