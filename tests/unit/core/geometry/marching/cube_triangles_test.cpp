// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/marching/cube_triangles.hpp"

#include <gtest/gtest.h>

#include <map>

#include "core/math/hash_random.hpp"
#include "tests/support/closed_mesh.hpp"
#include "tests/support/meshes.hpp"

using namespace thaw;

namespace {

constexpr int side = 12;  // corners along an axis; those at the border are outside

using InsideFlags = std::vector<std::uint8_t>;
int cornerAt(int x, int y, int z) { return x + side * (y + side * z); }

/// Marches all cubes of a grid, with vertices in the middle of their edges.
TriangleMesh meshOf(const InsideFlags& inside) {
  TriangleMesh mesh;
  std::map<std::pair<int, int>, std::uint32_t> onEdge;
  for (int z = 0; z + 1 < side; z++)
    for (int y = 0; y + 1 < side; y++)
      for (int x = 0; x + 1 < side; x++) {
        const auto corner = [&](int c) { return cornerAt(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)); };
        unsigned bits = 0;
        for (int c = 0; c < 8; c++) bits |= unsigned{inside[static_cast<std::size_t>(corner(c))]} << c;
        for (const auto& t : cubeTriangles(static_cast<std::uint8_t>(bits))) {
          std::array<std::uint32_t, 3> of;
          for (std::size_t k = 0; k < 3; k++) {
            const AxisEdge e = t[k];
            const auto [at, fresh] = onEdge.try_emplace({corner(e.from), e.axis},
                                                        static_cast<std::uint32_t>(onEdge.size()));
            Vec3d place{double(x + (e.from & 1)), double(y + (e.from >> 1 & 1)), double(z + (e.from >> 2))};
            place[e.axis] += 0.5;
            if (fresh) mesh.vertices.push_back(place);
            of[k] = at->second;
          }
          mesh.triangles.push_back(of);
        }
      }
  return mesh;
}

}  // namespace

TEST(CubeTriangles, OneCornerFacesAway) {
  const CubeTriangles& t = cubeTriangles(1);
  ASSERT_EQ(t.size(), 1u);
  InsideFlags inside(side * side * side, 0);
  inside[static_cast<std::size_t>(cornerAt(5, 5, 5))] = 1;
  EXPECT_NEAR(volumeOf(meshOf(inside)), 1.0 / 6, 1e-12);  // an octahedron
}

TEST(CubeTriangles, VerticesAreTheEdgesThatCross) {
  for (unsigned inside = 0; inside < 256; inside++) {
    std::map<std::pair<int, int>, bool> used;
    for (const auto& t : cubeTriangles(static_cast<std::uint8_t>(inside)))
      for (const AxisEdge& e : t) used[{e.from, e.axis}] = true;
    for (int corner = 0; corner < 8; corner++)
      for (int axis = 0; axis < 3; axis++) {
        const int to = corner | 1 << axis;
        if (to == corner) continue;
        EXPECT_EQ(used.count({corner, axis}) == 1, (inside >> corner & 1) != (inside >> to & 1)) << inside;
      }
  }
}

// Random corners give all cases next to each other. Every edge has two triangles with opposite directions.
TEST(CubeTriangles, MeshesOfRandomCornersAreClosed) {
  for (std::uint64_t seed = 0; seed < 40; seed++) {
    InsideFlags inside(side * side * side, 0);
    const double share = 0.1 + 0.8 * randomUniform(seed, Purpose::Test, 0);
    for (int z = 1; z + 1 < side; z++)
      for (int y = 1; y + 1 < side; y++)
        for (int x = 1; x + 1 < side; x++) {
          const int corner = cornerAt(x, y, z);
          inside[static_cast<std::size_t>(corner)] = randomUniform(seed, Purpose::Test,
                                                                   static_cast<std::uint64_t>(corner) + 1) <
                                                     share;
        }
    expectClosed(meshOf(inside));
  }
}
