// SPDX-License-Identifier: Apache-2.0
#include "core/flow/curvature/surface_curvature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/fluid/laws/surface_energy.hpp"
#include "core/halo/exchange.hpp"
#include "core/materials/surface_tension.hpp"
#include "core/math/tangent.hpp"
#include "core/walls/wall_surface_energy.hpp"

namespace thaw {
namespace {

/// Bounds of the colour gradient over that of a flat surface, between which the weight rises from 0 to 1.
/// Disorder inside the liquid gives up to 0.3.
constexpr double insideGradient = 0.35, surfaceGradientFrom = 0.6;

/// Distances from a wall in spacings: up to the first, the normal is that of the contact angle; from the
/// second, that of the colour gradient.
constexpr double wallNormalUpTo = 0.5, ownNormalFrom = 1.5;

double smoothStep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Vec3d unitOrZero(const Vec3d& v) {
  const double size = length(v);
  return size > 1e-12 ? v / size : Vec3d{};
}

void refreshSurface(const CurvatureContext& x, AnyColumn& column) {
  refresh(x.halo, x.world.particles, ColumnList{&column}).wait();
}

// From startNormals on, surfaceGradient is the outward unit normal times the weight of the particle in sums
// over the surface, and surfaceColour the curvature in 1/m.
double weightOf(const Continuum& p, std::uint32_t j) { return length(p.surfaceGradient[j]); }

/// Calls row(i, group, lane) for each owned row at the surface.
template<class Row> void eachAtSurface(const CurvatureContext& x, Row&& row) {
  const NeighbourLists& lists = x.neighbours;
  for (std::size_t g = 0; g < lists.groups; g++)
    for (std::size_t l = 0; l < 8; l++) {
      const std::uint32_t i = lists.self[8 * g + l];
      if (i != lists.dummy && weightOf(x.world.particles, i) > 0) row(i, g, l);
    }
}

/// Calls pair(j, d) for each neighbour at the surface, d = (x_j - x_i) / h.
template<class Pair>
void eachNeighbour(const CurvatureContext& x, std::uint32_t i, std::size_t g, std::size_t l, Pair&& pair) {
  const NeighbourLists& lists = x.neighbours;
  const Continuum& p = x.world.particles;
  for (std::uint32_t k = 0; k < lists.count[g]; k++) {
    const std::uint32_t j = lists.row(g, k, l);
    if (j == lists.dummy || p.surfaceGradient[j] == Vec3d{}) continue;
    const Vec3d d = (p.position[j] - p.position[i]) / x.world.grid.support;
    if (dot(d, d) < 1) pair(j, d);
  }
}

/// Returns the closest contact of a row with a wall, or null.
const WallContact* closestWall(const CurvatureContext& x, std::uint32_t row) {
  const WallContact* closest = nullptr;
  for (const WallContact& c : contactsOf(x.contacts, row))
    if (!closest || c.distance < closest->distance) closest = &c;
  return closest;
}

/// Replaces the normal close to a wall by that of the contact angle, n = m cos(theta) + t sin(theta). m is
/// the normal of the wall, and t the direction of the colour gradient along it. A film along the wall keeps
/// its own normal.
Vec3d normalAtWall(const CurvatureContext& x, std::uint32_t i, const Vec3d& n) {
  const WallContact* c = closestWall(x, i);
  const WallView& w = x.world;
  if (!c || c->distance >= ownNormalFrom * w.scene.spacing) return n;
  const Vec3d along = n - c->normal * dot(n, c->normal);
  const double size = length(along), wetting = wettingOf(w.scene.materials[w.particles.material[i]],
                                                         w.walls.list[c->wall].properties);
  const double share = std::clamp(
                           (ownNormalFrom - c->distance / w.scene.spacing) / (ownNormalFrom - wallNormalUpTo),
                           0.0, 1.0) *
                       std::clamp(10 * size - 0.5, 0.0, 1.0);
  if (share == 0) return n;
  const Vec3d atWall = c->normal * wetting + along * (std::sqrt(1 - wetting * wetting) / size);
  return unitOrZero(n * (1 - share) + atWall * share);
}

/// Normals and weights of owned rows from the colour gradient, walls included.
void startNormals(const CurvatureContext& x) {
  const WallView& w = x.world;
  Continuum& p = w.particles;
  const double spacing = w.scene.spacing / w.grid.support, flat = flatColourGradient(w.scene.numerics);
  for (const WallContact& c : x.contacts.list)
    p.surfaceGradient[c.row] += c.normal *
                                (wallColour(spacing, std::max(c.distance / w.grid.support, 0.0)).slope *
                                 c.share);
  for (std::uint32_t i = 0; i < p.owned; i++) {
    const double size = length(p.surfaceGradient[i]),
                 weight = smoothStep(insideGradient, surfaceGradientFrom, size / flat);
    if (weight == 0 || !(liquidFraction(p, i) > 0)) p.surfaceGradient[i] = {};
    else p.surfaceGradient[i] = p.surfaceGradient[i] * (-weight / size);
    p.surfaceColour[i] = 0;
  }
}

}  // namespace

double tensionAt(const WallView& w, std::uint32_t i) {
  const Material& m = w.scene.materials[w.particles.material[i]];
  return m.surfaceTensionTable.empty() ? m.surfaceTension : surfaceTensionAt(m, w.particles.temperature[i]);
}

double flatColourGradient(const Numerics& numerics) {
  const double e = 1 / numerics.support;
  const int n = static_cast<int>(numerics.support) + 1;
  double sum = 0;
  for (int k = 1; k <= n; k++)
    for (int a = -n; a <= n; a++)
      for (int b = -n; b <= n; b++) sum -= e * e * e * surfaceKernelAt(Vec3d{a * e, b * e, k * e}).gradient.z;
  return sum;
}

namespace {

/// Sets surfaceGradient to the normals, averaged over the neighbours, times the weights.
void findSurfaceNormals(const CurvatureContext& x) {
  Continuum& p = x.world.particles;
  startNormals(x);
  refreshSurface(x, p.surfaceGradient);
  std::vector<Vec3d> smooth(p.owned);
  eachAtSurface(x, [&](std::uint32_t i, std::size_t g, std::size_t l) {
    Vec3d sum = p.surfaceGradient[i];
    eachNeighbour(x, i, g, l,
                  [&](std::uint32_t j, const Vec3d& d) { sum += p.surfaceGradient[j] * (1 - dot(d, d)); });
    smooth[i] = normalAtWall(x, i, unitOrZero(sum)) * weightOf(p, i);
  });
  for (std::uint32_t i = 0; i < p.owned; i++) p.surfaceGradient[i] = smooth[i];
  refreshSurface(x, p.surfaceGradient);
}

/// Least-squares sums in the tangent plane of a particle. Lengths in support radii.
struct TangentFit {
  Vec3d first, second;                                         // tangents
  double xx = 0, xy = 0, yy = 0;                               // moments
  double slope[2][2] = {{0, 0}, {0, 0}}, tension[2] = {0, 0};  // slopes of normal and tension
  double number;                                               // sum of the kernel of a plane

  TangentFit(const Vec3d& normal, double own)
      : first(anyTangent(normal)), second(cross(normal, first)), number(own) {}

  void add(double weight, const Vec3d& d, const Vec3d& turn, double rise) {
    const double x = dot(d, first), y = dot(d, second), u = dot(turn, first), v = dot(turn, second);
    const double near = std::max(1 - x * x - y * y, 0.0), w = weight * (1 - dot(d, d));
    number += weight * near * near;
    xx += w * x * x, xy += w * x * y, yy += w * y * y;
    slope[0][0] += w * x * u, slope[0][1] += w * x * v;
    slope[1][0] += w * y * u, slope[1][1] += w * y * v;
    tension[0] += w * x * rise, tension[1] += w * y * rise;
  }
  /// Adds the mirror image of a neighbour behind a wall, so that the area beside the wall is not too large.
  void addImage(double weight, const Vec3d& d) {
    const double near = std::max(1 - dot(d, d), 0.0);
    number += weight * near * near;
  }
  bool solvable() const { return xx + yy > 1e-3; }
  /// Solves the fit. The small multiple of the identity bounds the slopes of particles with few neighbours.
  void solve() {
    const double small = 1e-3 * (xx + yy), a = xx + small, b = yy + small, det = a * b - xy * xy;
    const auto inverse = [&](double& s, double& t) {
      const double u = (b * s - xy * t) / det;
      t = (a * t - xy * s) / det;
      s = u;
    };
    inverse(slope[0][0], slope[1][0]), inverse(slope[0][1], slope[1][1]), inverse(tension[0], tension[1]);
  }
};

/// Returns the element of a particle, with the curvature before smoothing.
FreeSurfaceElement elementOf(const CurvatureContext& x, std::uint32_t i, std::size_t g, std::size_t l) {
  const WallView& w = x.world;
  const Continuum& p = w.particles;
  const double h = w.grid.support, own = weightOf(p, i);
  const Vec3d normal = unitOrZero(p.surfaceGradient[i]);
  TangentFit fit(normal, own);
  const WallContact* wall = closestWall(x, i);
  const auto image = [&](const Vec3d& d) {
    return d - wall->normal * (2 * (std::max(wall->distance, 0.0) / h + dot(d, wall->normal)));
  };
  if (wall) fit.addImage(own, image({}));
  const Material& m = w.scene.materials[p.material[i]];
  const bool varies = !m.surfaceTensionTable.empty();
  const double tension = varies ? tensionAt(w, i) : 0;
  eachNeighbour(x, i, g, l, [&](std::uint32_t j, const Vec3d& d) {
    const bool same = varies && p.material[j] == p.material[i];
    fit.add(weightOf(p, j), d, unitOrZero(p.surfaceGradient[j]) - normal,
            same ? tensionAt(w, j) - tension : 0);
    if (wall) fit.addImage(weightOf(p, j), image(d));
  });
  FreeSurfaceElement e;
  e.area = own * std::numbers::pi * h * h / (3 * fit.number);  // kernel 3 / (pi h^2) (1 - q^2)^2
  e.normal = normal;
  if (!fit.solvable()) return e;
  fit.solve();
  const double sum = (fit.slope[0][0] + fit.slope[1][1]) / h,
               product = (fit.slope[0][0] * fit.slope[1][1] - fit.slope[0][1] * fit.slope[1][0]) / (h * h);
  const double most = 4 / w.scene.spacing;  // a ball of one particle
  e.curvature = std::clamp(sum + product * w.scene.spacing, -most, most);
  e.tensionGradient = (fit.first * fit.tension[0] + fit.second * fit.tension[1]) / h;
  return e;
}

}  // namespace

std::vector<FreeSurfaceElement> findFreeSurface(const CurvatureContext& x) {
  Continuum& p = x.world.particles;
  findSurfaceNormals(x);
  std::vector<FreeSurfaceElement> elements(p.owned);
  eachAtSurface(x, [&](std::uint32_t i, std::size_t g, std::size_t l) {
    elements[i] = elementOf(x, i, g, l);
    p.surfaceColour[i] = elements[i].curvature;
  });
  refreshSurface(x, p.surfaceColour);
  eachAtSurface(x, [&](std::uint32_t i, std::size_t g, std::size_t l) {
    double weights = weightOf(p, i), sum = weights * p.surfaceColour[i];
    eachNeighbour(x, i, g, l, [&](std::uint32_t j, const Vec3d& d) {
      const double weight = weightOf(p, j) * (1 - dot(d, d));
      weights += weight, sum += weight * p.surfaceColour[j];
    });
    elements[i].curvature = sum / weights;
  });
  return elements;
}

}  // namespace thaw
