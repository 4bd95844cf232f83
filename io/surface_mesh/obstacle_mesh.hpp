// SPDX-License-Identifier: Apache-2.0
// Triangles of obstacles.
#pragma once
#include "core/geometry/basic/signed_distance.hpp"
#include "core/scene/scene.hpp"
#include "io/surface_mesh/surface_mesh.hpp"

namespace thaw {

/// Returns the surface of a bounded shape (m). Differences and intersections are polygonised; other shapes
/// are exact up to a sag of 0.2 % of their size.
TriangleMesh boundedMesh(const Shape& shape, const SignedDistance& distance);

/// Few: as in boundedMesh. Even: for other programs, without slivers (even_triangles.hpp). Differences and
/// intersections are then meshed around surfels on them (surface_mesh.hpp).
enum class ObstacleTriangles { Few, Even };

/// Returns the surface of an obstacle at rest (m) with normals, whose vertices are separate where edges are
/// sharp. A plane ends at the sides of the domain. Throws like makeSignedDistance.
ComponentMesh obstacleMesh(const Obstacle& obstacle, const Domain& domain,
                           ObstacleTriangles kind = ObstacleTriangles::Few);

}  // namespace thaw
