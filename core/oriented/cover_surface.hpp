// Particles all over a surface.
#pragma once
#include "core/geometry/signed_distance.hpp"
#include "core/geometry/triangle_mesh.hpp"
#include "core/oriented/made_points.hpp"

namespace thaw {

/// Points on a surface, about a spacing apart: projected samples of a fine lattice in an order that is a
/// hash, then moved apart along it. Only the parts of the lattice that may be near the surface are looked at.
/// Throws std::invalid_argument: the surface has no end, or is too long for its spacing.
MadePoints coverSurface(const SignedDistance& shape, double spacing, std::uint64_t seed);

/// The same on the triangles of a mesh, which may be open: as many as a hexagonal lattice has on its area,
/// and up to its border. Normals are those of the mesh.
MadePoints coverMesh(const TriangleMesh& mesh, double spacing, std::uint64_t seed);

}  // namespace thaw
