// The project's own shape to melt: the bust of a queen with a tall crown.
#pragma once
#include "core/geometry/triangle_mesh.hpp"

namespace thaw {

inline constexpr const char* builtinBust = "builtin:bust";  ///< what a scene calls it

/// Closed, outward mesh, 1 m tall, standing on z = 0 around the origin, facing -y. The same bits everywhere: only + - * / and roots.
TriangleMesh bustMesh();

}  // namespace thaw
