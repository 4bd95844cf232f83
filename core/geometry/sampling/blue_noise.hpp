// SPDX-License-Identifier: Apache-2.0
// Blue-noise samples on a triangle mesh.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

struct MeshSample {
  Vec3d position{};  ///< m, on the triangle
  std::uint32_t triangle = 0;
};

/// Part of a mesh that receives samples.
struct MeshPart {
  /// Returns true if the part may come within `reach` (m) of a position (m).
  std::function<bool(const Vec3d& middle, double reach)> near;
  /// Returns true if a position (m) on a triangle belongs to the part.
  std::function<bool(const Vec3d& place, std::uint32_t triangle)> isThere;
};

/// Returns samples with distances of about `spacing` (m), and the density of a hexagonal lattice. Triangles
/// are divided into pieces of at most 0.55 spacings, each with one random candidate. Dart throwing in a
/// hashed order accepts candidates at least 0.75 spacings apart (Poisson discs). Lloyd steps move samples to
/// the centroids of their candidates. Isolated candidates are then added, so no point of the mesh is farther
/// than `spacing` from a sample. The two sides of a thin sheet do not interact. All ranks sample the whole
/// mesh, with the same bits. Memory: 40 bytes per candidate, about 15 candidates per sample. With `part`,
/// only that part has candidates.
std::vector<MeshSample> blueNoise(const TriangleMesh& mesh, double spacing, std::uint64_t seed,
                                  const MeshPart* part = nullptr);

}  // namespace thaw
