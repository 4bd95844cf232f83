// SPDX-License-Identifier: Apache-2.0
// Built-in shape: the bust of a queen with a tall crown.
#pragma once
#include "core/geometry/basic/triangle_mesh.hpp"

namespace thaw {

inline constexpr const char* builtinBust = "builtin:bust";  ///< its name in scenes

/// Returns a closed mesh with outward triangles, 1 m tall, standing on z = 0 at the origin, facing -y. It is
/// made by elementary arithmetic and square roots only, so the bits are the same on all machines.
TriangleMesh bustMesh();

/// Returns the approximate signed distance (m) from the sculpture's surface, negative inside, in the frame of
/// the mesh. The mesh does not resolve details below 13 mm.
double bustValue(const Vec3d& x);

}  // namespace thaw
