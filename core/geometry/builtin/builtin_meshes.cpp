// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/builtin/builtin_meshes.hpp"

#include "core/geometry/builtin/sheet_meshes.hpp"

namespace thaw {

TriangleMesh builtinMesh(const std::string& name) {
  return name == builtinHead ? headSheet(1, 0.0135) : bustMesh();
}

}  // namespace thaw
