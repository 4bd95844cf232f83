// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/warnings/thin_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/scene/modules.hpp"
#include "core/simulation/setup/warnings/chosen_rows.hpp"

namespace thaw {
namespace {

constexpr double mostLookedAt = 20000;  // particles per body
constexpr double leastShare = 0.02;     // smallest reported fraction in thin walls; it excludes sharp edges

/// Returns true if something other than body b is liquid, at the start or later.
bool othersAreLiquid(const Scene& s, const Modules& m, std::size_t b) {
  const auto liquid = [&](const auto& source) {
    const Material& x = s.materials[static_cast<std::size_t>(source.material)];
    return (m.heat && x.melts()) || !solidAt(x, source.temperature);
  };
  for (std::size_t k = 0; k < s.bodies.size(); k++)
    if (k != b && liquid(s.bodies[k])) return true;
  return std::any_of(s.emitters.begin(), s.emitters.end(), liquid);
}

/// Wall at a position inside a shape, along the normal of the nearest surface.
struct WallThere {
  const SignedDistance& shape;
  double depth = 0;
  Vec3d normal{};
  WallThere(const SignedDistance& s, const Vec3d& x, double reach) : shape(s) {
    depth = -s.distanceWithin(x, reach, &normal);
  }
  /// Returns true if the wall is thinner than `thickness` (m).
  bool thinner(const Vec3d& x, double thickness) const {
    return depth < thickness && !shape.inside(x - normal * (thickness - depth));
  }
};

/// Returns the thickness (m), at most `most`, with an error of up to a hundredth of `most`.
double thicknessAt(const SignedDistance& shape, const Vec3d& x, double most) {
  const WallThere wall(shape, x, most);
  double low = wall.depth, high = most;
  while (high - low > 0.01 * most) {
    const double middle = 0.5 * (low + high);
    (wall.thinner(x, middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace

std::vector<SceneWarning> thinWalls(const World& w,
                                    const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                                    const std::vector<std::int64_t>& particles, Reducer& all) {
  const Scene& s = w.scene;
  const Continuum& p = w.particles;
  std::vector<SceneWarning> warnings;
  if (!w.modules.fluid || !w.modules.solid) return warnings;
  const std::size_t n = s.bodies.size();
  std::vector<std::uint8_t> wanted(n, 0);
  for (std::size_t b = 0; b < n; b++) wanted[b] = othersAreLiquid(s, w.modules, b);
  const double least = leastWall * s.spacing * (1 - 1e-6);
  std::vector<std::int64_t> counts(2 * n, 0);  // checked, thin
  std::vector<double> first(n, -never);        // lowest number of a particle in a thin wall, negated
  std::vector<Vec3d> place(n);
  for (std::size_t i = 0; i < p.owned; i++) {
    const std::size_t b = p.body[i];
    if (b >= n || !wanted[b] || p.phase[i] != Solid) continue;
    if (!chosenById(p.id[i], particles[b], mostLookedAt)) continue;
    const std::uint64_t number = numberOf(p.id[i]);
    counts[2 * b]++;
    if (!WallThere(*shapes[b], p.position[i], least).thinner(p.position[i], least)) continue;
    counts[2 * b + 1]++;
    if (-static_cast<double>(number) > first[b])
      first[b] = -static_cast<double>(number), place[b] = p.position[i];
  }
  all.sum(counts);
  for (std::size_t b = 0; b < n; b++) {
    const double share = counts[2 * b] > 0
                             ? static_cast<double>(counts[2 * b + 1]) / static_cast<double>(counts[2 * b])
                             : 0;
    if (share < leastShare) continue;
    double lowest = first[b], at[3];
    all.maximum({&lowest, 1});
    for (int a = 0; a < 3; a++) at[a] = first[b] == lowest ? place[b][a] : -never;
    all.maximum(at);
    const double thick = thicknessAt(*shapes[b], {at[0], at[1], at[2]}, least);
    char text[300];
    std::snprintf(
        text, sizeof text,
        "': %.0f %% of it lies in walls thinner than %g spacings, about %.2g m at (%.4g, %.4g, %.4g): "
        "liquid may pass through them; "
        "reduce the spacing to %.2g m or less, or thicken the walls",
        100 * share, leastWall, thick, at[0], at[1], at[2], thick / leastWall);
    warnings.push_back({s.bodies[b].where, "body '" + s.bodies[b].name + text});
  }
  return warnings;
}

}  // namespace thaw
