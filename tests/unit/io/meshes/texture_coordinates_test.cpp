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

/// A strip along x. The texture begins again in its middle, between rows 19 and 20.
struct StripWithSeam {
  TriangleMesh mesh;
  std::vector<Uv> uv;
  StripWithSeam() {
    for (std::uint32_t k = 0; k < 40; k++) {
      for (int side = 0; side < 2; side++) {
        const Vec3d x{0.1 * k, 0.1 * side, 0};
        mesh.vertices.push_back(x);
        uv.push_back(chartOf(k >= 20, x));
      }
      if (k == 0) continue;
      mesh.triangles.push_back({2 * k - 2, 2 * k, 2 * k - 1});
      mesh.triangles.push_back({2 * k, 2 * k + 1, 2 * k - 1});
    }
  }
  static Uv chartOf(bool second, const Vec3d& x) {
    const double u = second ? 0.7 + 0.1 * (x.x - 2) : 0.1 * x.x;
    return {static_cast<float>(u), static_cast<float>(0.1 * x.y)};
  }
};

TEST(TextureCoordinates, TrianglesAcrossASeamContinueOneChart) {
  const StripWithSeam strip;
  const auto corners = cornerUvs(strip.mesh, strip.uv);
  ASSERT_EQ(corners.size(), strip.mesh.triangles.size());
  for (std::size_t t = 0; t < corners.size(); t++)
    for (std::size_t k = 0; k < 3; k++) {
      // triangle 38 has two corners on the first chart, triangle 39 has two on the second one
      const Uv exact = StripWithSeam::chartOf(t > 38, strip.mesh.vertices[strip.mesh.triangles[t][k]]);
      for (std::size_t c = 0; c < 2; c++) EXPECT_NEAR(corners[t][k][c], exact[c], 2e-4) << t << ' ' << k;
      if (t < 38 || t > 39) { EXPECT_EQ(corners[t][k], strip.uv[strip.mesh.triangles[t][k]]); }
    }
}

TEST(TextureCoordinates, VerticesAreDuplicatedAtSeams) {
  const StripWithSeam strip;
  ComponentMesh split;
  split.mesh = strip.mesh;
  split.uvs = strip.uv;
  split.colours.resize(strip.uv.size());
  split.normals.resize(strip.uv.size());
  for (std::size_t v = 0; v < strip.uv.size(); v++) split.temperatures.push_back(static_cast<float>(v));
  splitAtSeams(split);
  ASSERT_EQ(split.mesh.vertices.size(), strip.mesh.vertices.size() + 2);
  EXPECT_EQ(split.uvs.size(), split.mesh.vertices.size());
  EXPECT_EQ(split.colours.size(), split.mesh.vertices.size());
  EXPECT_EQ(split.normals.size(), split.mesh.vertices.size());
  EXPECT_TRUE(split.velocities.empty());
  const auto corners = cornerUvs(strip.mesh, strip.uv);
  for (std::size_t t = 0; t < corners.size(); t++)
    for (std::size_t k = 0; k < 3; k++) {
      const std::uint32_t v = split.mesh.triangles[t][k], before = strip.mesh.triangles[t][k];
      EXPECT_EQ(split.uvs[v], corners[t][k]);
      EXPECT_EQ(split.temperatures[v], static_cast<float>(before));
      EXPECT_EQ(length(split.mesh.vertices[v] - strip.mesh.vertices[before]), 0);
    }
}
