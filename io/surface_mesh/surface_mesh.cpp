// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/surface_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "io/surface_mesh/improve_triangles.hpp"
#include "io/surface_mesh/march_band.hpp"
#include "io/surface_mesh/mesh_detail.hpp"
#include "io/surface_mesh/offset_vertices.hpp"

namespace thaw {

namespace {

using Corner = BandGrid::Corner;

/// Surfels of a mesh: an unwrapped component, and near images where it is cut at periodic sides.
struct Patch {
  SurfaceFrame frame;  // positions, normals, radii and colours only
  PeriodicSides sides;
  std::array<bool, 3> cut{};  // per axis
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  double radius = 0;           // m, mean
  ObstacleDistance obstacles;  // empty for none
  Vec3f meanColour{};
  double largest() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

Vec3f colourOf(const Rgb& c) {
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

bool usable(const SurfaceFrame& f, std::size_t i) {
  const Vec3d& x = f.positions[i];
  const Vec3f& n = f.normals[i];
  return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z) && std::isfinite(n.x) &&
         std::isfinite(n.y) && std::isfinite(n.z) && dot(n, n) > 0 && std::isfinite(f.radii[i]) &&
         f.radii[i] > 0;
}

double reachOf(const Patch& p, std::size_t i, double spacing) {
  return planeReach * p.frame.radii[i] + spacing;
}

BandGrid gridAround(const Patch& p, double spacing) {
  double reach = 0;
  for (std::size_t i = 0; i < p.frame.radii.size(); i++) reach = std::max(reach, reachOf(p, i, spacing));
  Vec3d origin, edge;
  Corner count;
  double blocks = 1;
  for (int a = 0; a < 3; a++) {
    const std::size_t k = static_cast<std::size_t>(a);
    double n;
    if (p.cut[k]) {  // corners on both sides, and one beyond each
      const double cubes = std::max(1.0, std::ceil(p.sides.period[a] / spacing));
      edge[a] = p.sides.period[a] / cubes;
      origin[a] = p.sides.min[a] - edge[a];
      n = cubes + 3;
    } else {  // two cubes beyond the reach of all surfels, so the border is outside
      const double margin = reach + 2 * spacing;
      edge[a] = spacing;
      origin[a] = p.low[a] - margin;
      n = std::ceil((p.high[a] + margin - origin[a]) / spacing) + 1;
    }
    blocks *= std::ceil(n / BandGrid::side);
    if (!(n < 1e6) || !(blocks < 1e9))
      throw std::runtime_error(
          "a component extends too far for a mesh at the spacing of its surfels: remove surfels that moved "
          "away, or raise --cell");
    count[k] = static_cast<std::int64_t>(n);
  }
  return BandGrid(origin, edge, count, p.cut);
}

Patch patchOf(const SurfaceFrame& frame, const ComponentRows& component, const std::vector<Rgb>& colours,
              const PeriodicSides& sides) {
  std::vector<std::uint32_t> rows;
  for (const std::uint32_t i : component.rows)
    if (usable(frame, i)) rows.push_back(i);
  UnwrappedComponent whole = unwrapComponent(frame, rows, sides);
  Patch p;
  p.sides = sides;
  p.cut = whole.selfJoined;
  for (std::size_t k = 0; k < rows.size(); k++) {
    const std::uint32_t i = rows[k];
    p.frame.normals.push_back(frame.normals[i]);
    p.frame.radii.push_back(frame.radii[i]);
    p.frame.colours.push_back(colours[i]);
    p.radius += frame.radii[i] / static_cast<double>(rows.size());
    p.meanColour += colourOf(colours[i]) / static_cast<float>(rows.size());
    for (int a = 0; a < 3; a++)
      p.low[a] = std::min(p.low[a], whole.positions[k][a]),
      p.high[a] = std::max(p.high[a], whole.positions[k][a]);
  }
  p.frame.positions = std::move(whole.positions);
  return p;
}

/// Adds the images of surfels that reach corners on the other side of a cut.
Patch withImages(Patch p, double spacing) {
  for (int a = 0; a < 3; a++) {
    if (!p.cut[static_cast<std::size_t>(a)]) continue;
    const double period = p.sides.period[a], min = p.sides.min[a];
    const std::size_t before = p.frame.radii.size();
    for (std::size_t i = 0; i < before; i++) {
      const double reach = reachOf(p, i, 2 * spacing), most = std::ceil(reach / period);
      for (double n = -most; n <= most; n++) {
        Vec3d x = p.frame.positions[i];
        x[a] += n * period;
        if (n == 0 || x[a] < min - reach || x[a] > min + period + reach) continue;
        p.frame.positions.push_back(x);
        p.frame.normals.push_back(p.frame.normals[i]);
        p.frame.radii.push_back(p.frame.radii[i]);
        p.frame.colours.push_back(p.frame.colours[i]);
      }
    }
  }
  return p;
}

/// Replaces normals that point into the mesh, where surfels of crumpled or torn surfaces contradict each
/// other, by the mean of the adjacent triangles.
void turnNormalsOutward(ComponentMesh& m) {
  std::vector<Vec3d> sums(m.mesh.vertices.size());
  const std::vector<Vec3d>& x = m.mesh.vertices;
  for (const auto& t : m.mesh.triangles) {
    const Vec3d normal = cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]);
    for (const std::uint32_t v : t) sums[v] += normal;
  }
  for (std::size_t v = 0; v < sums.size(); v++) {
    const double size = length(sums[v]);
    if (size > 0 && dot(sums[v], wide(m.normals[v])) < 0) m.normals[v] = single(sums[v] / size);
  }
}

/// Returns the distance to the walls near a component. Walls with a surfel that is deeper than its radius are
/// left out: they overlap the body.
ObstacleDistance distanceToWalls(const SurfaceFrame& surfels, const Walls& walls) {
  std::vector<const Wall*> near;
  for (const Wall& wall : walls.list) {
    double least = never;  // distance over radius
    for (std::size_t i = 0; wall.present && i < surfels.radii.size() && !(least < -1); i++) {
      const double radius = surfels.radii[i];
      least = std::min(
          least, wall.shape->distanceWithin(toRest(wall.pose, surfels.positions[i]), 4 * radius) / radius);
    }
    if (least >= -1 && least < 4) near.push_back(&wall);
  }
  if (near.empty()) return {};
  return [near](const Vec3d& x, Vec3d& gradient) {
    double least = never;
    for (const Wall* wall : near) {
      Vec3d normal{};
      const double d = wall->shape->distance(toRest(wall->pose, x), &normal);
      if (d < least) least = d, gradient = directionFromRest(wall->pose, normal);
    }
    return least;
  };
}

ComponentMesh meshAt(const Patch& p, double spacing, bool improved) {
  BandGrid grid = gridAround(p, spacing);
  const BandHeights heights = heightsAround(p.frame, grid, p.obstacles);
  const PlaneField planes(p.frame, grid.spacing(), p.obstacles);
  std::vector<std::uint8_t> isInside(grid.slots());
  for (std::size_t s = 0; s < isInside.size(); s++) isInside[s] = heights.values[s] < 0;
  grid.classify(isInside);
  MarchedBand band = marchBand(grid, heights, planes, p.meanColour, improved);
  removeFragments(band, planes, grid.spacing());
  if (improved && improveTriangles(band, planes, grid.spacing()) > 0)
    removeFragments(band, planes, grid.spacing());
  offsetVertices(band, 0.1 * grid.spacing());
  turnNormalsOutward(band.mesh);
  return std::move(band.mesh);
}

}  // namespace

std::vector<ComponentRows> rowsByComponent(const SurfaceFrame& frame) {
  std::vector<std::uint32_t> order(frame.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return frame.components[a] < frame.components[b];
  });
  std::vector<ComponentRows> all;
  for (const std::uint32_t i : order) {
    if (all.empty() || all.back().component != frame.components[i]) all.push_back({frame.components[i], {}});
    all.back().rows.push_back(i);
  }
  return all;
}

ComponentMesh meshOfComponent(const SurfaceFrame& frame, const ComponentRows& component,
                              const std::vector<Rgb>& colours, const PeriodicSides& sides, double cell) {
  return detailedMeshOfComponent(frame, component, colours, sides, {.cell = cell});
}

ComponentMesh detailedMeshOfComponent(const SurfaceFrame& frame, const ComponentRows& component,
                                      const std::vector<Rgb>& colours, const PeriodicSides& sides,
                                      const MeshDetail& detail) {
  ComponentMesh mesh;
  mesh.component = component.component;
  Patch own = patchOf(frame, component, colours, sides);
  if (own.frame.radii.empty()) return mesh;
  if (detail.walls) own.obstacles = distanceToWalls(own.frame, *detail.walls);
  const double asked = detail.cell * own.radius;
  double edge = std::min(asked, detail.mostOfSize * own.largest());
  for (int n = 0; n < 4 && edge > 0.01 * own.radius && mesh.mesh.triangles.empty(); n++, edge *= 0.5) {
    mesh = meshAt(withImages(own, edge), edge, detail.improved);
    mesh.edge = edge;
  }
  mesh.component = component.component;
  mesh.asked = asked;
  mesh.cut = own.cut;
  return mesh;
}

}  // namespace thaw
