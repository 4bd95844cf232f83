// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/accuracy/made_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "io/scene/scene_for_all.hpp"

namespace thaw::accuracy {
namespace {

TriangleMesh cube() {
  TriangleMesh m;
  for (int c = 0; c < 8; c++)
    m.vertices.push_back({c & 1 ? 1.0 : -1.0, c & 2 ? 1.0 : -1.0, c & 4 ? 1.0 : -1.0});
  m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return m;
}

/// An icosahedron split five times, with its vertices moved onto the ball and its bumps.
TriangleMesh ball(double bumps) {
  TriangleMesh m;
  const double g = 0.5 * (1 + std::sqrt(5.0));
  m.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  m.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int k = 0; k < 5; k++) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, fresh] = middles.try_emplace(std::minmax(a, b),
                                                   static_cast<std::uint32_t>(m.vertices.size()));
      if (fresh) m.vertices.push_back(normalized(m.vertices[a] + m.vertices[b]));
      return at->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : m.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    m.triangles = finer;
  }
  for (Vec3d& v : m.vertices) {
    v = normalized(v);
    v = v * (1 + bumps * std::cos(9 * v.x) * std::cos(9 * v.y) * std::cos(9 * v.z));
  }
  return m;
}

}  // namespace

MeshLoader suiteMeshes() {
  return [files = meshLoader()](const std::string& path) {
    const std::string name = path.substr(path.rfind('/') + 1);  // scenes prefix their folder
    if (name == "made_ball.obj") return ball(0);
    if (name == "made_bumps.obj") return ball(0.04);
    if (name == "made_cube.obj") return cube();
    return files(path);
  };
}

}  // namespace thaw::accuracy
