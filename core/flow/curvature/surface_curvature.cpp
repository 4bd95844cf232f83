// SPDX-License-Identifier: Apache-2.0
#include "core/flow/curvature/surface_curvature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/flow/curvature/surface_loops.hpp"
#include "core/flow/curvature/tangent_fit.hpp"
#include "core/fluid/laws/particle_pressure.hpp"
#include "core/fluid/laws/surface_energy.hpp"
#include "core/halo/exchange.hpp"
#include "core/materials/surface_tension.hpp"
#include "core/walls/wall_surface_energy.hpp"

namespace thaw {
namespace {

/// Colour gradients, relative to that of a flat surface, between which the weight rises from 0 to 1. Disorder
/// inside the liquid causes values up to 0.3.
constexpr double insideGradient = 0.35, surfaceGradientFrom = 0.6;

/// Distances from a wall in spacings. Up to the first distance, the normal follows from the contact angle.
/// Beyond the second, it follows from the colour gradient.
constexpr double wallNormalUpTo = 0.5, ownNormalFrom = 1.5;

/// Colours, relative to the full lattice, between which a layer becomes resolved. A film of one layer has
/// 0.62, and a flat face 0.81.
constexpr double filmColour = 0.68, faceColour = 0.8;

/// Sums of 1 - q^2 over neighbours at the same face, between which an edge becomes resolved. The edge of a
/// film of one layer has 1.5, and of a film of two layers 4.
constexpr double fewNeighbours = 2, enoughNeighbours = 3.5;

/// Largest area of an element in squares of the spacing. The area of an element with few neighbours would be
/// too large.
constexpr double largestArea = 2;

/// Largest difference between the curvature from normals and the curvature from positions, times the spacing.
/// Disorder on a smooth surface causes values up to 1.5.
constexpr double curvatureMargin = 2;

Vec3d unitOrZero(const Vec3d& v) {
  const double size = length(v);
  return size > 1e-12 ? v / size : Vec3d{};
}

void refreshSurface(const CurvatureContext& x, AnyColumn& column) {
  refresh(x.halo, x.world.particles, ColumnList{&column}).wait();
}

/// Returns the closest contact of a row with a wall, or null.
const WallContact* closestWall(const CurvatureContext& x, std::uint32_t row) {
  const WallContact* closest = nullptr;
  for (const WallContact& c : contactsOf(x.contacts, row))
    if (!closest || c.distance < closest->distance) closest = &c;
  return closest;
}

/// Near a wall, replaces the normal by the one that follows from the contact angle, n = m cos(theta) + t
/// sin(theta). Here m is the normal of the wall, and t the direction of the colour gradient along the wall. A
/// film along the wall keeps its own normal.
Vec3d normalAtWall(const CurvatureContext& x, std::uint32_t i, const Vec3d& n) {
  const WallContact* c = closestWall(x, i);
  const WallView& w = x.world;
  if (!c || c->distance >= ownNormalFrom * w.scene.spacing) return n;
  const Vec3d along = n - c->normal * dot(n, c->normal);
  const double size = length(along), wetting = wettingAt(w, *c);
  const double share = std::clamp(
                           (ownNormalFrom - c->distance / w.scene.spacing) / (ownNormalFrom - wallNormalUpTo),
                           0.0, 1.0) *
                       std::clamp(10 * size - 0.5, 0.0, 1.0);
  if (share == 0) return n;
  const Vec3d atWall = c->normal * wetting + along * (std::sqrt(1 - wetting * wetting) / size);
  return unitOrZero(n * (1 - share) + atWall * share);
}

/// Normals and weights of owned rows from the colour gradient, walls included. surfaceColour becomes the
/// colour over that of the full lattice, the particle itself included.
///
/// At contact angles beyond 90 degrees, a drop overhangs its wall. For the direction of the normal, the wall
/// then counts partly as gas, and wholly at 180 degrees. Otherwise the kernel would fill the wedge of gas,
/// and the surface would appear upright.
void startNormals(const CurvatureContext& x) {
  const WallView& w = x.world;
  Continuum& p = w.particles;
  const double spacing = w.scene.spacing / w.grid.support, flat = flatColourGradient(w.scene.numerics);
  const SurfaceMeasure measure = surfaceMeasure(w.scene.numerics, w.scene.spacing);
  std::vector<Vec3d> gas(p.owned);
  for (const WallContact& c : x.contacts.list) {
    const WallColour wall = wallColour(spacing, std::max(c.distance / w.grid.support, 0.0));
    const Vec3d slope = c.normal * (wall.slope * c.share);
    p.surfaceGradient[c.row] += slope;
    p.surfaceColour[c.row] += wall.colour * c.share;
    gas[c.row] += slope * std::min(wettingAt(w, c), 0.0);
  }
  for (std::uint32_t i = 0; i < p.owned; i++) {
    const double weight = smoothStep(insideGradient, surfaceGradientFrom,
                                     length(p.surfaceGradient[i]) / flat);
    if (weight == 0 || !(liquidFraction(p, i) > 0)) p.surfaceGradient[i] = {};
    else p.surfaceGradient[i] = unitOrZero(p.surfaceGradient[i] + gas[i]) * -weight;
    p.surfaceColour[i] = (p.surfaceColour[i] + measure.self) / (measure.full + measure.self);
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

/// Sets FreeSurfaceElement::resolved of owned rows from the colour, or from the number of neighbours at the
/// same face of the surface. A single liquid particle on a solid has the colour of the solid, but no resolved
/// surface.
void findResolved(const CurvatureContext& x, std::vector<FreeSurfaceElement>& elements) {
  const Continuum& p = x.world.particles;
  for (std::uint32_t i = 0; i < p.owned; i++)
    elements[i].resolved = smoothStep(filmColour, faceColour, p.surfaceColour[i]);
  eachAtSurface(x, [&](std::uint32_t i, std::size_t g, std::size_t l) {
    double& resolved = elements[i].resolved;
    const bool onSolid = p.liquid.active && hasSolidNeighbour(x, g, l);
    if (resolved == 1 && !onSolid) return;
    double number = 0;
    eachNeighbour(x, i, g, l, [&](std::uint32_t j, const Vec3d& d) {
      number += weightOf(p, j) * (1 - dot(d, d)) * sameFace(p.surfaceGradient[i], p.surfaceGradient[j]);
    });
    const double byNumber = smoothStep(fewNeighbours, enoughNeighbours, number);
    resolved = onSolid ? byNumber : std::max(resolved, byNumber);
  });
}

/// Sets surfaceGradient to the normals, averaged over the neighbours, times the weights.
void findSurfaceNormals(const CurvatureContext& x, std::vector<FreeSurfaceElement>& elements) {
  Continuum& p = x.world.particles;
  startNormals(x);
  refreshSurface(x, p.surfaceGradient);
  findResolved(x, elements);
  std::vector<Vec3d> smooth(p.owned);
  eachAtSurface(x, [&](std::uint32_t i, std::size_t g, std::size_t l) {
    const Vec3d own = p.surfaceGradient[i];
    Vec3d sum = own;
    eachNeighbour(x, i, g, l, [&](std::uint32_t j, const Vec3d& d) {
      sum += p.surfaceGradient[j] * ((1 - dot(d, d)) * sameFace(own, p.surfaceGradient[j]));
    });
    smooth[i] = normalAtWall(x, i, unitOrZero(sum)) * weightOf(p, i);
  });
  for (std::uint32_t i = 0; i < p.owned; i++) p.surfaceGradient[i] = smooth[i];
  refreshSurface(x, p.surfaceGradient);
}

/// Returns the gradient (N/m^2) of the tension, scaled to the surface half a spacing outside of the
/// particles. The scale is the ratio of the areas. In a direction of curvature k, lengths grow by 1 + k dx
/// / 2. Curvature and gradient then refer to the same surface, so the forces on a closed surface add up to 0.
Vec3d gradientOutside(const TangentFit& fit, double h, double dx) {
  const double half = 0.5 * dx / h;
  double xx = half * fit.slope[0][0], yy = half * fit.slope[1][1],
         xy = 0.5 * half * (fit.slope[0][1] + fit.slope[1][0]);
  const double largest = std::max({std::abs(xx), std::abs(xy), std::abs(yy), 1.0});  // at least 1, for a
                                                                                     // single particle
  xx /= largest, xy /= largest, yy /= largest;
  const double u = fit.tension[0] / h, v = fit.tension[1] / h;
  return fit.first * ((1 + yy) * u - xy * v) + fit.second * ((1 + xx) * v - xy * u);
}

/// Sets the element of a particle, with the curvature before smoothing.
void findElement(const CurvatureContext& x, std::uint32_t i, std::size_t g, std::size_t l,
                 FreeSurfaceElement& e) {
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
    const double weight = weightOf(p, j) * sameFace(normal, p.surfaceGradient[j]);
    fit.add(weight, d, unitOrZero(p.surfaceGradient[j]) - normal, same ? tensionAt(w, j) - tension : 0);
    if (wall) fit.addImage(weight, image(d));
  });
  const double dx = w.scene.spacing, kernelSum = 3 * fit.number / (std::numbers::pi * h * h);
  e.area = std::min(own / kernelSum, largestArea * dx * dx);
  e.normal = normal;
  if (!fit.solvable()) return;
  if (!wall || wall->distance >= ownNormalFrom * dx) e.bulge = fit.bulge() / h;
  fit.solve();
  const double sum = (fit.slope[0][0] + fit.slope[1][1]) / h,
               product = (fit.slope[0][0] * fit.slope[1][1] - fit.slope[0][1] * fit.slope[1][0]) / (h * h);
  const double most = 4 / dx;  // a ball of one particle
  e.curvature = std::clamp(sum + product * dx, -most, most);
  e.tensionGradient = gradientOutside(fit, h, dx);
}

/// Averages the curvature over the neighbours. The average does not push a particle further that sticks
/// out of the surface or lies below it.
double meanCurvature(const CurvatureContext& x, std::uint32_t i, std::size_t g, std::size_t l, double bulge) {
  const Continuum& p = x.world.particles;
  double weights = weightOf(p, i), sum = weights * p.surfaceColour[i];
  eachNeighbour(x, i, g, l, [&](std::uint32_t j, const Vec3d& d) {
    const double weight = weightOf(p, j) * (1 - dot(d, d)) *
                          sameFace(p.surfaceGradient[i], p.surfaceGradient[j]);
    weights += weight, sum += weight * p.surfaceColour[j];
  });
  const double mean = sum / weights, margin = curvatureMargin / x.world.scene.spacing;
  return bulge < never ? std::clamp(mean, bulge - margin, bulge + margin) : mean;
}

}  // namespace

std::vector<FreeSurfaceElement> findFreeSurface(const CurvatureContext& x) {
  Continuum& p = x.world.particles;
  std::vector<FreeSurfaceElement> elements(p.owned);
  findSurfaceNormals(x, elements);
  for (std::uint32_t i = 0; i < p.owned; i++) p.surfaceColour[i] = 0;
  eachAtSurface(x, [&](std::uint32_t i, std::size_t g, std::size_t l) {
    findElement(x, i, g, l, elements[i]);
    p.surfaceColour[i] = elements[i].curvature;
  });
  for (std::uint32_t i = 0; i < p.owned; i++)
    p.surfaceGradient[i] = elements[i].normal * (elements[i].area * elements[i].resolved);
  refresh(x.halo, p, ColumnList{&p.surfaceGradient, &p.surfaceColour}).wait();
  eachAtSurface(x, [&](std::uint32_t i, std::size_t g, std::size_t l) {
    elements[i].curvature = meanCurvature(x, i, g, l, elements[i].bulge);
  });
  return elements;
}

}  // namespace thaw
