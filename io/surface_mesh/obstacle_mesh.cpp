// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/obstacle_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/geometry/marching/polygonise.hpp"
#include "core/geometry/marching/sharp_edges.hpp"
#include "core/geometry/meshes/mesh_normals.hpp"
#include "core/geometry/shapes/shape_mesh.hpp"
#include "io/image/image.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/surface_mesh/even_triangles.hpp"
#include "io/surface_mesh/remove_slivers.hpp"

namespace thaw {

namespace {

constexpr double cellsAcross = 80;  // cubes along the longest side of a polygonised shape

bool isCut(const Shape& shape) {
  return shape.kind == ShapeKind::Difference || shape.kind == ShapeKind::Intersection ||
         std::any_of(shape.parts.begin(), shape.parts.end(), isCut);
}

/// Returns the part of a convex polygon with dot(normal, x) <= height.
std::vector<Vec3d> clipped(const std::vector<Vec3d>& polygon, const Vec3d& normal, double height) {
  std::vector<Vec3d> kept;
  for (std::size_t k = 0; k < polygon.size(); k++) {
    const Vec3d &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double over = dot(normal, a) - height, next = dot(normal, b) - height;
    if (over <= 0) kept.push_back(a);
    if ((over < 0 && next > 0) || (over > 0 && next < 0))
      kept.push_back(a + (over / (over - next)) * (b - a));
  }
  return kept;
}

/// Returns the part of a plane in the domain, or a large square if the plane lies outside.
TriangleMesh planeMesh(const Vec3d& normal, double height, const Domain& domain) {
  const Vec3d middle = 0.5 * (domain.min + domain.max),
              foot = middle - (dot(normal, middle) - height) * normal;
  const Vec3d u = normalized(cross(normal, std::abs(normal.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0})),
              v = cross(normal, u);
  const double half = length(domain.max - domain.min);
  std::vector<Vec3d> square{foot - half * u - half * v, foot + half * u - half * v,
                            foot + half * u + half * v, foot - half * u + half * v};
  std::vector<Vec3d> polygon = square;
  const double margin = 1e-9 * half;  // a plane at a side of the domain is in it
  for (int a = 0; a < 3; a++) {
    Vec3d axis{};
    axis[a] = 1;
    polygon = clipped(polygon, axis, domain.max[a] + margin);
    polygon = clipped(polygon, -axis, -domain.min[a] + margin);
  }
  return evenPolygon(polygon.size() >= 3 ? polygon : square);
}

double largestSize(const SignedDistance& distance) {
  const Bounds box = distance.bounds();
  const Vec3d size = box.max - box.min;
  return std::max({size.x, size.y, size.z});
}

TriangleMesh marchedMesh(const SignedDistance& distance) {
  const Bounds box = distance.bounds();
  const double edge = largestSize(distance) / cellsAcross;
  const Vec3d margin{2 * edge, 2 * edge, 2 * edge};
  return polygonise([&](const Vec3d& x) { return distance.distanceWithin(x, 2 * edge); },
                    {box.min - margin, box.max + margin}, edge);
}

double volumeOf(const TriangleMesh& mesh) {
  double volume = 0;
  for (const auto& t : mesh.triangles)
    volume += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6;
  return volume;
}

/// Returns a mesh around surfels at the vertices of a polygonised shape; the mesh itself if it loses thin
/// parts.
TriangleMesh resurfaced(const TriangleMesh& marched, const SignedDistance& distance, double edge) {
  constexpr double most = 0.01;  // difference of the volumes
  SurfaceFrame surfels;
  ComponentRows rows;
  for (const Vec3d& x : marched.vertices) {
    Vec3d normal;
    const double away = distance.distanceWithin(x, edge, &normal);
    rows.rows.push_back(static_cast<std::uint32_t>(surfels.positions.size()));
    surfels.positions.push_back(x - away * normal);
    surfels.normals.push_back(single(normal));
    surfels.radii.push_back(static_cast<float>(edge));
  }
  surfels.colours.assign(surfels.positions.size(), Rgb{});
  TriangleMesh even = meshOfComponent(surfels, rows, surfels.colours).mesh;
  const double volume = volumeOf(marched);
  return std::abs(volumeOf(even) - volume) <= most * volume ? even : marched;
}

TriangleMesh evenMesh(const Shape& shape, const SignedDistance& distance) {
  const double largest = largestSize(distance);
  if (!isCut(shape)) return evenShapeMesh(shape, 2e-3 * largest, meshLoader());
  const double edge = largest / cellsAcross;
  TriangleMesh mesh = resurfaced(marchedMesh(distance), distance, edge);
  removeSlivers(mesh, moveOntoEdges(mesh, distance, edge));
  return mesh;
}

TriangleMesh meshOf(const Obstacle& obstacle, const Domain& domain, ObstacleTriangles kind) {
  const auto distance = makeSignedDistance(obstacle.shape, meshLoader());
  const Bounds box = distance->bounds();
  const Vec3d size = box.max - box.min;
  if (!std::isfinite(length(size))) {
    Vec3d normal;
    const double away = distance->distance({}, &normal);
    return planeMesh(normal, -away, domain);
  }
  return kind == ObstacleTriangles::Even ? evenMesh(obstacle.shape, *distance)
                                         : boundedMesh(obstacle.shape, *distance);
}

/// Returns a mesh with normals, whose vertices are separate where edges are sharp.
ComponentMesh withNormals(const TriangleMesh& mesh, const Vec3f& colour) {
  const MeshNormals normals(mesh);
  ComponentMesh out;
  std::map<std::tuple<std::uint32_t, int, int, int>, std::uint32_t> made;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t++) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; k++) {
      const std::uint32_t v = mesh.triangles[t][k];
      const Vec3d n = normals.at(mesh.vertices[v], t);
      const auto step = [](double x) { return static_cast<int>(std::lround(50 * x)); };
      const auto [place, isNew] = made.try_emplace({v, step(n.x), step(n.y), step(n.z)},
                                                   static_cast<std::uint32_t>(out.mesh.vertices.size()));
      if (isNew) {
        out.mesh.vertices.push_back(mesh.vertices[v]);
        out.normals.push_back(single(n));
        out.colours.push_back(colour);
      }
      corners[k] = place->second;
    }
    out.mesh.triangles.push_back(corners);
  }
  return out;
}

}  // namespace

TriangleMesh boundedMesh(const Shape& shape, const SignedDistance& distance) {
  const double largest = largestSize(distance);
  if (!isCut(shape)) return shapeMesh(shape, 2e-3 * largest, meshLoader());
  return withSharpEdges(marchedMesh(distance), distance, largest / cellsAcross);
}

ComponentMesh obstacleMesh(const Obstacle& obstacle, const Domain& domain, ObstacleTriangles kind) {
  const Rgb c = rgbOf(obstacle.colour);
  return withNormals(meshOf(obstacle, domain, kind),
                     {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)});
}

}  // namespace thaw
