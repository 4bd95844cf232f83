// Evenly spread places on a triangle mesh, without a pattern.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

struct MeshSample {
  Vec3d position{};  ///< m, on the triangle
  std::uint32_t triangle = 0;
};

/// What of a mesh is to have places, where not all of it is.
struct MeshPart {
  std::function<bool(const Vec3d& middle, double reach)> near;  ///< may something of it be within `reach` (m)
                                                                ///< of a place?
  /// does a place on a triangle belong to it?
  std::function<bool(const Vec3d& place, std::uint32_t triangle)> isThere;
};

/// Places about `spacing` (m) apart, as many as a hexagonal lattice of it has. Candidates (one at random in
/// each piece of a triangle that is at most 0.55 spacings across) are taken in a hashed order where none was
/// taken within 0.75 spacings (Poisson discs, by dart throwing); then each place moves to the middle of the
/// candidates nearest to it, a few times (Lloyd), and candidates that are left alone are taken, too: no point
/// of the mesh is farther than `spacing` from a place. The two sides of a thin sheet do not see each other.
/// The same bits on any rank: all see the whole mesh. Memory: 40 bytes a candidate, about 15 candidates a
/// place. With `part` only what is in it has candidates.
std::vector<MeshSample> blueNoise(const TriangleMesh& mesh, double spacing, std::uint64_t seed,
                                  const MeshPart* part = nullptr);

}  // namespace thaw
