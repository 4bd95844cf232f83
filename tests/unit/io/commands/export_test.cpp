// SPDX-License-Identifier: Apache-2.0
// Files of `thaw export`, read back, and its errors.
#include <cstring>

#include "io/commands/render.hpp"
#include "io/export/export_surface.hpp"
#include "io/meshes/read_mesh.hpp"
#include "io/render/frame_source.hpp"
#include "io/render/movie.hpp"
#include "tests/support/export_fixture.hpp"

using namespace thaw;
using namespace thaw::test;

TEST_F(Export, MeshesAreReadBack) {
  const fs::path frame = surfaceFrame(1);
  ASSERT_EQ(run(frame, "ply"), 0);
  ASSERT_EQ(run(frame, "obj", folder / "out.obj", "temperature"), 0);
  const TriangleMesh ply = readMesh((folder / "export" / "wax_surface_000001.ply").string()),
                     obj = readMesh((folder / "out.obj").string());
  EXPECT_EQ(ply.triangles, obj.triangles);
  EXPECT_NEAR(volumeOf(ply), 4.18879 * (0.125 + 0.008), 0.01);
  EXPECT_NEAR(volumeOf(obj), volumeOf(ply), 1e-6);
  const std::string text = contentOf(folder / "out.obj");
  EXPECT_NE(text.find("o component_3\n"), std::string::npos);
  EXPECT_NE(text.find("o component_9\n"), std::string::npos);
}

// The sides are those of the scene stored in the frame.
TEST_F(Export, MeshesAcrossPeriodicSidesAreWholeOrReported) {
  const auto across = [&](const std::string& name, auto addSurfels) {
    SurfelSamples s;
    addSurfels(s);
    for (Vec3f& x : s.positions) x.x -= std::floor(x.x);
    const std::string scene =
        "# ---- x.toml\nspacing = 0.1\nend = 1\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\nsides = { x = "
        "\"periodic\" }\n[material.oil]\n[[body]]\nmaterial = \"oil\"\nsphere = { radius = 0.2 }\nplace = { "
        "move = [0.5, 0.5, 0.5] }\n";
    const fs::path frame = folder / "frames" / (name + "_surface_000001.hdf");
    writeSurfaceFrame(frame.string(), s, 0.1, true, scene);
    testing::internal::CaptureStdout();
    EXPECT_EQ(run(frame, "ply", folder / (name + ".ply")), 0);
    return testing::internal::GetCapturedStdout();
  };
  EXPECT_EQ(across("ball",
                   [](SurfelSamples& s) {
                     sampleBall(s, {0.95, 0.5, 0.5}, 0.3, 0.05, 3);
                   })
                .find("periodic"),
            std::string::npos);
  const TriangleMesh ball = readMesh((folder / "ball.ply").string());
  EXPECT_NEAR(volumeOf(ball), 4.18879 * 0.027, 0.01 * 0.113);
  double high = 0;
  for (const Vec3d& v : ball.vertices) high = std::max(high, v.x);
  EXPECT_NEAR(high, 1.25, 0.01);
  const std::string said = across("rod", [](SurfelSamples& s) {
    SurfelSamples rod;
    sampleMesh(rod, boxMesh({-1, 0.3, 0.3}, {2, 0.6, 0.7}), 0.05, false, 3);
    for (std::size_t i = 0; i < rod.size(); i++)
      if (rod.positions[i].x >= 0 && rod.positions[i].x < 1)
        s.add({rod.positions[i].x, rod.positions[i].y, rod.positions[i].z},
              {rod.normals[i].x, rod.normals[i].y, rod.normals[i].z}, 0.05, 3);
  });
  EXPECT_NE(
      said.find("component 3, which extends through the periodic sides along x, is cut there and capped"),
      std::string::npos)
      << said;
  EXPECT_NE(contentOf(folder / "rod.ply").find("comment component 3 (body 0), which extends through"),
            std::string::npos);
  EXPECT_NEAR(volumeOf(readMesh((folder / "rod.ply").string())), 0.12, 0.01 * 0.12);
}

TEST_F(Export, CubesWiderThanABodyAreReported) {
  ExportOptions o;
  o.input = surfaceFrame(1), o.as = "ply";
  for (const double cell : {1.0, 10.0}) {
    o.cell = cell;
    testing::internal::CaptureStderr();
    EXPECT_EQ(exportCommand(o), 0);
    const std::string said = testing::internal::GetCapturedStderr();
    if (cell == 1) EXPECT_EQ(said, "");
    else
      EXPECT_NE(said.find("--cell 10: cubes of 0.5 m are too wide for 2 of 2 components, which use finer "
                          "ones; 0.5 to 2 is recommended"),
                std::string::npos)
          << said;
  }
}

TEST_F(Export, DiscsLieOnTheSurfels) {
  const fs::path frame = surfaceFrame(1);
  ASSERT_EQ(run(frame, "ply-discs"), 0);
  const TriangleMesh m = readMesh((folder / "export" / "wax_surface_000001.discs.ply").string());
  ASSERT_EQ(m.vertices.size(), 8 * surfels.size());
  for (std::size_t i = 0; i < surfels.size(); i += 37)
    for (std::size_t k = 0; k < 8; k++) {
      const Vec3d d = m.vertices[8 * i + k] -
                      Vec3d{surfels.positions[i].x, surfels.positions[i].y, surfels.positions[i].z};
      EXPECT_NEAR(length(d), surfels.radii[i], 1e-6);
      EXPECT_NEAR(d.x * surfels.normals[i].x + d.y * surfels.normals[i].y + d.z * surfels.normals[i].z, 0,
                  1e-6);
    }
  // Corners run counterclockwise seen from outside.
  for (std::size_t t = 0; t < m.triangles.size(); t += 91) {
    const auto& c = m.triangles[t];
    const Vec3f& n = surfels.normals[c[0] / 8];
    EXPECT_GT(dot(cross(m.vertices[c[1]] - m.vertices[c[0]], m.vertices[c[2]] - m.vertices[c[0]]),
                  Vec3d{n.x, n.y, n.z}),
              0);
  }
}

TEST_F(Export, VtpAndPovHoldEverySurfel) {
  const fs::path frame = surfaceFrame(1);
  ASSERT_EQ(run(frame, "vtp"), 0);
  ASSERT_EQ(run(frame, "pov"), 0);
  const std::string vtp = contentOf(folder / "export" / "wax_surface_000001.vtp");
  for (const char* name : {"normal", "radius", "color", "id", "component", "liquid", "temperature", "detail",
                           "connectivity", "offsets", "Points"})
    EXPECT_NE(vtp.find("Name=\"" + std::string(name) + "\""), std::string::npos) << name;
  // The points are where their element states, after their length.
  const std::size_t element = vtp.find("Name=\"Points\""),
                    offset = std::stoul(vtp.substr(vtp.find("offset=\"", element) + 8));
  const char* points = vtp.data() + vtp.find("<AppendedData encoding=\"raw\">\n_") + 31 + offset;
  std::uint64_t bytes;
  std::memcpy(&bytes, points, 8);
  EXPECT_EQ(bytes, 12 * surfels.size());
  float x[3];
  std::memcpy(x, points + 8 + 12 * 5, 12);
  EXPECT_EQ(x[2], surfels.positions[5].z);
  const std::string pov = contentOf(folder / "export" / "wax_surface_000001.pov");
  std::size_t discs = 0;
  for (std::size_t at = 0; (at = pov.find("\ndisc{", at)) != std::string::npos; at++) discs++;
  EXPECT_EQ(discs, surfels.size());
  EXPECT_NE(pov.find("camera {"), std::string::npos);
  EXPECT_NE(pov.find("light_source {"), std::string::npos);
}

TEST_F(Export, ExportsAllFramesAndReportsEveryError) {
  surfaceFrame(0), surfaceFrame(1);
  const fs::path particles = particleFrame(0);
  EXPECT_EQ(run(folder, "ply", folder / "meshes"), 0);
  EXPECT_TRUE(fs::exists(folder / "meshes" / "wax_surface_000000.ply") &&
              fs::exists(folder / "meshes" / "wax_surface_000001.ply"));
  EXPECT_EQ(run(particles, "ply"), 3);
  EXPECT_EQ(run(folder / "nowhere", "ply"), 3);
  EXPECT_EQ(run(folder, "stl"), 2);
  EXPECT_EQ(run(folder, "ply", {}, "pressure"), 3);
  if (fs::exists("/dev/full")) {
    fs::create_symlink("/dev/full", folder / "meshes" / "full.obj.part");
    EXPECT_EQ(run(surfaceFrame(0), "obj", folder / "meshes" / "full.obj"), 3);
    EXPECT_FALSE(fs::exists(folder / "meshes" / "full.obj"));
  }
}

TEST_F(Export, FilmIsMadeByTheProgramOrByItsCommand) {
  fs::create_directories(folder / "Ann's");
  const std::vector<fs::path> pictures{folder / "Ann's" / "a_000001.png", folder / "Ann's" / "a_000002.png"};
  for (const fs::path& p : pictures) writePng(Image(65, 41, {200, 100, 0}), p);
  const fs::path film = folder / "Ann's" / "a.mp4", bad = folder / "bad_000001.png";
  const bool made = makeMovie(pictures, film, 25);
  EXPECT_EQ(fs::exists(film), made);
  EXPECT_FALSE(fs::exists(film.string() + ".part"));
  std::ofstream(bad) << "no picture";
  const std::string error = errorOf([&] { makeMovie({bad}, folder / "bad.mp4", 25); });
  EXPECT_FALSE(fs::exists(folder / "bad.mp4"));
  if (!made) {
    EXPECT_EQ(error, "no error");
    GTEST_SKIP() << "ffmpeg is not installed";
  }
  EXPECT_NE(error.find("ffmpeg failed"), std::string::npos) << error;
  EXPECT_NE(errorOf([&] {
              makeMovie({pictures[0], folder / "lost.png"}, folder / "bad.mp4", 25);
            }).find("cannot be read"),
            std::string::npos);
  const std::string bytes = contentOf(film);
  EXPECT_GT(bytes.size(), 500u);
  fs::remove(film);
  EXPECT_EQ(std::system(movieCommand(pictures, film, 25).c_str()), 0);
  EXPECT_EQ(contentOf(film), bytes);
}
