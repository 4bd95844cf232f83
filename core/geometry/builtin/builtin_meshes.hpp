// SPDX-License-Identifier: Apache-2.0
// Built-in meshes that scenes can name instead of a file.
#pragma once
#include <string>

#include "core/geometry/builtin/bust.hpp"

namespace thaw {

inline constexpr const char* builtinHead = "builtin:head";  ///< headSheet
                                                            ///< (core/geometry/builtin/sheet_meshes.hpp), 1 m
                                                            ///< tall, 22,000 triangles
inline constexpr const char* builtinList = "\"builtin:bust\" or \"builtin:head\"";

/// Returns true if the name refers to a built-in mesh, existing or not, and not to a file.
inline bool namesBuiltin(const std::string& name) { return name.rfind("builtin:", 0) == 0; }
inline bool isBuiltin(const std::string& name) { return name == builtinBust || name == builtinHead; }

/// Requires: isBuiltin(name).
TriangleMesh builtinMesh(const std::string& name);

}  // namespace thaw
