// The project's own shape to melt: the bust of a queen with a tall crown.
#pragma once
#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

inline constexpr const char* builtinBust = "builtin:bust";  ///< what a scene calls it

/// Closed, outward mesh, 1 m tall, standing on z = 0 around the origin, facing -y. The same bits everywhere:
/// only + - * / and roots.
TriangleMesh bustMesh();

/// The sculpture that the mesh is of: about the distance from its surface in m, negative inside, in the frame
/// of the mesh. The mesh rounds off what is finer than 13 mm of it.
double bustValue(const Vec3d& x);

}  // namespace thaw
