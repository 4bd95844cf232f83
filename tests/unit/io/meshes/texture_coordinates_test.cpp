// SPDX-License-Identifier: Apache-2.0
#include "io/meshes/texture_coordinates.hpp"

#include <gtest/gtest.h>

#include "io/export/texture_seams.hpp"
#include "io/meshes/read_mesh.hpp"

using namespace thaw;

namespace {

// A square of two triangles with u = x and v = 2 y.
const char* const square =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 2\nvt 0 2\nvn 0 0 1\n"
    "f 1/1/1 2/2/1 3/3/1 4/-1/1\n";

}  // namespace

TEST(TextureCoordinates, ObjHasThemAtCorners) {
  const TexturedMesh m = parseTexturedObj(square, "square.obj");
  ASSERT_EQ(m.uv.size(), 2u);
  EXPECT_EQ(m.uv[1][2], (Uv{0, 2}));
  EXPECT_EQ(parseObj(square, "square.obj").triangles, m.mesh.triangles);
  EXPECT_TRUE(parseTexturedObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "a.obj").uv.empty());
  EXPECT_THROW(parseTexturedObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nf 1/1 2/2 3/1\n", "a.obj"), MeshError);
  EXPECT_THROW(parseTexturedObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0\nf 1/1 2/1 3/1\n", "a.obj"), MeshError);
}

TEST(TextureCoordinates, PlyHasThemAtVertices) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float s\nproperty float y\n"
      "property float t\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
      "end_header\n0 0.1 0 0.2 0\n1 0.3 0 0.4 0\n1 0.5 1 0.6 0\n3 0 1 2\n";
  const TexturedMesh m = parseTexturedPly(ply, "a.ply");
  ASSERT_EQ(m.uv.size(), 1u);
  EXPECT_EQ(m.uv[0][2], (Uv{0.5f, 0.6f}));
  EXPECT_EQ(m.mesh.vertices[2].y, 1);
}

TEST(TextureCoordinates, AreInterpolatedOnTheSurface) {
  const TextureLookup texture(parseTexturedObj(square, "square.obj"));
  const Uv uv = texture.at({0.25, 0.5, 0.3});
  EXPECT_NEAR(uv[0], 0.25, 1e-6);
  EXPECT_NEAR(uv[1], 1, 1e-6);
}

TEST(TextureCoordinates, TrianglesAcrossASeamAreNotSmeared) {
  TriangleMesh strip;
  std::vector<Uv> uv;
  for (std::uint32_t k = 0; k < 40; k++) {
    strip.vertices.push_back({0.1 * k, 0, 0});
    strip.vertices.push_back({0.1 * k, 0.1, 0});
    // the texture begins again in the middle
    const float u = 0.01f * static_cast<float>(k < 20 ? k : k - 20) + (k < 20 ? 0 : 0.7f);
    uv.push_back({u, 0});
    uv.push_back({u, 0.01f});
    if (k == 0) continue;
    strip.triangles.push_back({2 * k - 2, 2 * k, 2 * k - 1});
    strip.triangles.push_back({2 * k, 2 * k + 1, 2 * k - 1});
  }
  const auto corners = cornerUvs(strip, uv);
  ASSERT_EQ(corners.size(), strip.triangles.size());
  for (std::size_t t = 0; t < corners.size(); t++)
    for (std::size_t k = 0; k < 3; k++) {
      EXPECT_LT(std::abs(corners[t][k][0] - corners[t][0][0]), 0.1);
      if (t < 38 || t > 39) { EXPECT_EQ(corners[t][k], uv[strip.triangles[t][k]]); }
    }
}
