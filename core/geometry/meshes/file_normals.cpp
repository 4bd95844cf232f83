// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/meshes/file_normals.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/disjoint_sets.hpp"

namespace thaw {

Vec3d unitNormal(const Vec3d& n) {
  const double most = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
  return most > 0 ? normalized(n / most) : Vec3d{};  // scaled first, because squares of the components may
                                                     // overflow or underflow
}

void validateNormals(TriangleMesh& m, MeshReport& report) {
  if (m.normals.empty()) return;
  const auto side = [&](std::size_t t) {
    const auto& c = m.triangles[t];
    return cross(m.vertices[c[1]] - m.vertices[c[0]], m.vertices[c[2]] - m.vertices[c[0]]);
  };
  DisjointSets shells(m.vertices.size());
  for (const auto& t : m.triangles) shells.join(t[0], t[1]), shells.join(t[0], t[2]);
  std::vector<std::int64_t> outward(m.vertices.size(), 0);  // by a shell's first vertex: number of outward
                                                            // normals minus inward ones
  for (std::size_t t = 0; t < m.triangles.size(); t++)
    for (const Vec3d& n : m.normals[t]) {
      const double d = dot(n, side(t));
      outward[shells.find(m.triangles[t][0])] += (d > 0) - (d < 0);
    }
  for (std::size_t t = 0; t < m.triangles.size(); t++) {
    const bool turned = outward[shells.find(m.triangles[t][0])] < 0;
    const bool ofFile = static_cast<std::int64_t>(t) < report.triangles;  // other triangles close holes
    for (Vec3d& n : m.normals[t]) {
      const bool given = dot(n, n) > 0;
      if (turned) n = -n;
      const bool used = given && dot(n, side(t)) > 0;
      report.normals += ofFile;
      report.turnedNormals += turned && given;
      report.unusedNormals += ofFile && !used;
      if (!used) n = {};
    }
  }
}

}  // namespace thaw
