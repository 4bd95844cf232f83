// SPDX-License-Identifier: Apache-2.0
// Sampling of a whole surface with particles.
#pragma once
#include "core/geometry/basic/signed_distance.hpp"
#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/oriented/sampling/sample_points.hpp"

namespace thaw {

/// Returns points on a surface, about one spacing (m) apart. Lattice points near the surface are projected,
/// selected in a hashed order, and relaxed along the surface. Throws std::invalid_argument if the surface is
/// infinite or too large for its spacing.
SampledPoints sampleSurface(const SignedDistance& shape, double spacing, std::uint64_t seed);

/// Returns the same for the triangles of a mesh, which may be open. Points reach the mesh's border, with the
/// density of a hexagonal lattice. Normals are those of the mesh.
SampledPoints sampleOpenMesh(const TriangleMesh& mesh, double spacing, std::uint64_t seed);

}  // namespace thaw
