// SPDX-License-Identifier: Apache-2.0
// `thaw export` and `thaw render` of sheets and oriented particles, across periodic sides, and of frames
// without a surface.
#include <cstring>

#include "io/commands/render.hpp"
#include "io/export/export_surface.hpp"
#include "io/meshes/read_mesh.hpp"
#include "io/render/frame_source.hpp"
#include "io/render/movie.hpp"
#include "tests/support/export_fixture.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

/// Two triangles of a square, and a triangle of another sheet.
fs::path writeSheets(const fs::path& path) {
  const std::vector<Vec3d> places{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                  {0, 0, 2}, {1, 0, 2}, {0, 1, 2}};
  const std::vector<std::uint16_t> bodies{0, 0, 0, 0, 1, 1, 1};
  const std::vector<std::uint8_t> colours(21, 90);
  Frame frame;
  frame.count = places.size();
  frame.meshed = true;
  frame.triangles = {0, 1, 2, 0, 2, 3, 4, 5, 6};
  frame.positions = {"position", "m", Scalar::F64, 3, places.data()};
  frame.fields = {{"sheet_body", "1", Scalar::U16, 1, bodies.data()},
                  {"color", "1", Scalar::U8, 3, colours.data()}};
  startMpi();
  writeFrame(path.string(), MPI_COMM_SELF, frame, {});
  return path;
}

}  // namespace

TEST_F(Export, PicturesShowBodiesAcrossPeriodicSidesInOnePiece) {
  PeriodicSides sides;
  sides.is[0] = true;
  sides.min = {0, -1, 0}, sides.period = {3, 2, 2};
  for (auto& x : surfels.positions)
    if (x.x < 0) x.x += 3;  // half of the first ball
  const fs::path frame = surfaceFrame(1);
  const auto widest = [](const FrameView& view) {
    float least = 10, most = -10;
    for (std::size_t i = 0; i < view.positions.size(); i++)
      if (view.components[i] == 3)
        least = std::min(least, view.positions[i].x), most = std::max(most, view.positions[i].x);
    return most - least;
  };
  EXPECT_GT(widest(readFrameView(frame, "surface")), 2.9f);
  EXPECT_LT(widest(readFrameView(frame, "surface", sides)), 1.01f);
}

TEST_F(Export, SheetsKeepTheirTriangles) {
  const fs::path frame = writeSheets(folder / "frames" / "cloth_sheet_000001.hdf");
  for (const std::string as : {"ply", "obj"}) {
    const fs::path out = folder / ("cloth." + as);
    ASSERT_EQ(run(frame, as, out), 0);
    const TriangleMesh m = readMesh(out.string());
    ASSERT_EQ(m.triangles.size(), 3u);
    EXPECT_EQ(m.vertices.size(), 7u);
    double area = 0;
    for (const auto& t : m.triangles)
      area += 0.5 * cross(m.vertices[t[1]] - m.vertices[t[0]], m.vertices[t[2]] - m.vertices[t[0]]).z;
    EXPECT_NEAR(area, 1.5, 1e-6);
  }
  ASSERT_EQ(run(frame, "vtp", folder / "cloth.vtp"), 0);
  const std::string vtp = contentOf(folder / "cloth.vtp");
  for (const char* part :
       {"NumberOfPoints=\"7\"", "NumberOfPolys=\"3\"", "type=\"UInt16\" Name=\"sheet_body\"",
        "type=\"UInt8\" Name=\"color\" NumberOfComponents=\"3\""})
    EXPECT_NE(vtp.find(part), std::string::npos) << part;
  EXPECT_EQ(run(frame, "pov", folder / "cloth.pov"), 2);
  ASSERT_EQ(run(frame, "usda", folder / "cloth.usda"), 0);
  const std::string usd = contentOf(folder / "cloth.usda");
  for (const char* part : {"def Mesh \"sheet_0\"", "def Mesh \"sheet_1\"", "uniform bool doubleSided = 1",
                           "0: [0, 1, 2, 0, 2, 3],"})
    EXPECT_NE(usd.find(part), std::string::npos) << part;
}

// Rows are on the ranks in any order. A curve has no triangles.
TEST_F(Export, OrientedParticlesAreInIdOrderWithLinesOfCurves) {
  for (const std::string as : {"ply", "obj", "vtp"}) {
    std::string first;
    for (const std::size_t turn : {0, 5, 13}) {
      const fs::path out = folder / ("o" + std::to_string(turn) + "." + as);
      ASSERT_EQ(run(writeOriented(folder / "frames" / "o_oriented_000001.hdf", turn), as, out), 0);
      const std::string now = contentOf(out);
      if (first.empty()) first = now;
      EXPECT_EQ(now, first) << as << " " << turn;
    }
    const char* has = as == "ply"   ? "property uint id_high\nproperty uint id_low\nelement face 10"
                      : as == "obj" ? "\nl 13 14\n"
                                    : "NumberOfLines=\"4\" NumberOfStrips=\"0\" NumberOfPolys=\"10\"";
    EXPECT_NE(first.find(has), std::string::npos) << as;
  }
  EXPECT_NE(contentOf(folder / "o0.ply").find("element edge 4\nproperty int vertex1"), std::string::npos);
  EXPECT_EQ(readMesh((folder / "o0.obj").string()).triangles.size(), 10u);
  ASSERT_EQ(run(folder / "frames" / "o_oriented_000001.hdf", "usda", folder / "o.usda"), 0);
  const std::string usd = contentOf(folder / "o.usda");
  for (const char* part : {"def Mesh \"oriented\"", "def BasisCurves \"oriented_curves\"",
                           "token type = \"linear\"", "int[] curveVertexCounts", "0: [5],"})
    EXPECT_NE(usd.find(part), std::string::npos) << part << usd;
  const std::string obj = contentOf(folder / "o0.obj");
  EXPECT_NE(obj.find("o oriented_0\n"), std::string::npos);
  EXPECT_NE(obj.find("o oriented_0_1\n"), std::string::npos) << "the second group of the body";
}

TEST_F(Export, ReadsItsFrames) {
  const SurfaceFrame f = readSurfaceFrame(surfaceFrame(1).string());
  EXPECT_EQ(f.time, 0.1);
  ASSERT_EQ(f.positions.size(), surfels.size());
  EXPECT_EQ(f.ids, surfels.ids);  // 64 bits, the top one set
  EXPECT_EQ(f.components, surfels.components);
  EXPECT_EQ(f.colours, surfels.rgb());
  EXPECT_EQ(f.radii, surfels.radii);
  EXPECT_TRUE(f.find("temperature") && f.find("liquid") && f.find("detail") && !f.find("normal"));
  EXPECT_FALSE(readSurfaceFrame(surfaceFrame(1).string(), [](const std::string& n) {
                 return n == "liquid";
               }).find("detail"));
  EXPECT_NE(errorOf([&] { readSurfaceFrame(particleFrame(1).string()); }).find("is not a frame of a surface"),
            std::string::npos);
}

TEST_F(Export, SurfaceIsDrawnIfPresent) {
  const fs::path particles = particleFrame(1);
  EXPECT_EQ(findFrames(folder), std::vector<fs::path>{particles});
  EXPECT_NE(
      errorOf([&] {
        findFrames(folder, FrameKind::Surface);
      }).find("no surface frames in this folder, only frames of particles, sheets or oriented particles"),
      std::string::npos);
  const fs::path surface = surfaceFrame(1);
  EXPECT_EQ(findFrames(folder), std::vector<fs::path>{surface});
  EXPECT_EQ(findFrames(folder, FrameKind::Particles), std::vector<fs::path>{particles});
  std::ofstream(folder / "frames" / "wax.hdf.series")
      << R"({"file-series-version":"1.0","files":[{"name":"wax_000001.hdf","time":0.1}]})";
  EXPECT_EQ(findFrames(folder), std::vector<fs::path>{surface});
  std::ofstream(folder / "frames" / "wax_surface.hdf.series")
      << R"({"file-series-version":"1.0","files":[{"name":"wax_surface_000001.hdf","time":0.1}]})";
  EXPECT_EQ(findFrames(folder), std::vector<fs::path>{surface});
  EXPECT_EQ(findFrames(folder, FrameKind::Particles), std::vector<fs::path>{particles});
  RenderOptions o;
  o.input = folder, o.width = 80, o.height = 60;
  EXPECT_EQ(renderCommand(o), 0);
  EXPECT_TRUE(fs::exists(folder / "pictures" / "wax_surface_000001.png"));
  o.what = "particles";
  EXPECT_EQ(renderCommand(o), 0);
  EXPECT_TRUE(fs::exists(folder / "pictures" / "wax_000001.png"));
  o.what = "surface";
  for (const char* field : {"surface", "glow", "liquid", "none"})
    EXPECT_EQ((o.field = field, renderCommand(o)), 0) << field;
  EXPECT_EQ((o.field = "pressure", renderCommand(o)), 3);
}
