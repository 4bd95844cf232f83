// SPDX-License-Identifier: Apache-2.0
// Images of obstacles across periodic sides.
#include <algorithm>
#include <cmath>

#include "core/walls/walls.hpp"

namespace thaw {
namespace {

/// Tolerance for equal lengths, relative to the domain.
constexpr double rounding = 1e-9;

bool isPeriodic(const Domain& d, int a) { return d.side[static_cast<std::size_t>(a)][0] == Side::Periodic; }
double lengthOf(const Domain& d, int a) { return d.max[a] - d.min[a]; }

/// Returns true if a wall is at least as long as the domain along an axis, and so has no images along it.
bool spansDomain(const Domain& d, const Wall& wall, int a) {
  return !(wall.bounds.max[a] - wall.bounds.min[a] < lengthOf(d, a) * (1 - rounding));
}

/// Returns bounds of all positions of a moving wall. For rotating walls they contain the bounding box at any
/// angle about the origin.
Bounds sweptBounds(const Wall& wall) {
  Bounds box = wall.bounds;
  const std::vector<Keyframe>& motion = wall.properties.motion;
  const bool turns = std::ranges::any_of(motion, [](const Keyframe& k) { return !(k.rotate == Vec3d{}); });
  if (turns) {
    double radius2 = 0;
    for (int a = 0; a < 3; a++) radius2 += std::pow(std::max(std::abs(box.min[a]), std::abs(box.max[a])), 2);
    const double radius = std::sqrt(radius2);
    box = {{-radius, -radius, -radius}, {radius, radius, radius}};
  }
  if (motion.empty()) return box;
  Bounds moves{motion.front().move, motion.front().move};
  for (const Keyframe& k : motion)
    for (int a = 0; a < 3; a++) {
      moves.min[a] = std::min(moves.min[a], k.move[a]);
      moves.max[a] = std::max(moves.max[a], k.move[a]);
    }
  return {box.min + moves.min, box.max + moves.max};
}

/// Range of periods, first to last, by which a shifted wall comes within `reach` of the domain.
struct ImageRange {
  int first = 0, last = 0;
};
ImageRange imagesAlong(const Domain& d, const Wall& wall, const Bounds& swept, double reach, int a) {
  if (!isPeriodic(d, a) || spansDomain(d, wall, a)) return {};
  const double period = lengthOf(d, a);
  const double first = std::ceil((d.min[a] - reach - swept.max[a]) / period);
  const double last = std::floor((d.max[a] + reach - swept.min[a]) / period);
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace

// The density of walls in contact depends on their order, so an image directly follows its original in the
// list.
void addWallImages(const Domain& d, double reach, Walls& walls) {
  std::vector<Wall> all;
  for (Wall& wall : walls.list) {
    const Bounds swept = sweptBounds(wall);
    ImageRange n[3];
    for (int a = 0; a < 3; a++) n[a] = imagesAlong(d, wall, swept, reach, a);
    const std::size_t own = all.size();
    all.push_back(std::move(wall));
    for (int z = n[2].first; z <= n[2].last; z++)
      for (int y = n[1].first; y <= n[1].last; y++)
        for (int x = n[0].first; x <= n[0].last; x++) {
          if (x == 0 && y == 0 && z == 0) continue;
          Wall image = all[own];
          image.shift = {x * lengthOf(d, 0), y * lengthOf(d, 1), z * lengthOf(d, 2)};
          image.imageOf = own;
          all.push_back(std::move(image));
        }
  }
  walls.list = std::move(all);
}

std::string unevenAxes(const Domain& d, const Wall& wall, double reach) {
  constexpr int points = 65;  // along each edge of a side
  std::string axes;
  for (int a = 0; a < 3; a++) {
    if (!isPeriodic(d, a) || !spansDomain(d, wall, a)) continue;
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    bool even = true;
    for (int k = 0; k < points * points && even; k++) {
      Vec3d low = d.min;
      low[b] += lengthOf(d, b) * (k % points) / (points - 1);
      low[c] += lengthOf(d, c) * (k / points) / (points - 1);
      Vec3d high = low;
      high[a] = d.max[a];
      const auto near = [&](const Vec3d& x) {
        return std::clamp(wall.shape->distanceWithin(x, reach), -reach, reach);
      };
      even = std::abs(near(low) - near(high)) < 1e-6 * lengthOf(d, a);
    }
    if (!even) axes += "xyz"[a];
  }
  return axes;
}

}  // namespace thaw
