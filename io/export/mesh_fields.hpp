// SPDX-License-Identifier: Apache-2.0
// Fields at the vertices of meshes that share a file.
#pragma once
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "io/surface_mesh/surface_mesh.hpp"

namespace thaw {

/// Values of meshes that lack a field which others in the file have: obstacles at rest have no velocity.
inline constexpr float noNumber = std::numeric_limits<float>::quiet_NaN();
inline constexpr Vec3f noVector{0, 0, 0};
inline constexpr std::array<float, 2> noUv{noNumber, noNumber};

/// Returns a vertex's value of a field, or `lacking` if its mesh has none.
template<class T> const T& valueAt(const std::vector<T>& field, std::size_t vertex, const T& lacking) {
  return vertex < field.size() ? field[vertex] : lacking;
}

/// Fields of a file: those that at least one of its meshes has.
struct MeshFields {
  bool velocities = false, temperatures = false, liquid = false, uvs = false;
  explicit MeshFields(const std::vector<ComponentMesh>& meshes) {
    for (const ComponentMesh& m : meshes) {
      velocities = velocities || !m.velocities.empty();
      temperatures = temperatures || !m.temperatures.empty();
      liquid = liquid || !m.liquid.empty();
      uvs = uvs || !m.uvs.empty();
    }
  }
};

/// Returns the label of a mesh's component; -1 for obstacles, sheets and other meshes without a component.
inline std::int64_t labelOf(const ComponentMesh& mesh) {
  return mesh.name.empty() ? static_cast<std::int64_t>(mesh.component) : -1;
}

}  // namespace thaw
