// The files of `thaw export`, read back, and its errors.
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <sstream>

#include "io/commands/export.hpp"
#include "io/commands/render.hpp"
#include "io/export/export_surface.hpp"
#include "io/meshes/read_mesh.hpp"
#include "io/render/frame_source.hpp"
#include "io/render/movie.hpp"
#include "tests/support/surfel_samples.hpp"

using namespace thaw;
namespace fs = std::filesystem;

namespace {

class Export : public testing::Test {
 protected:
  fs::path folder = fs::path(testing::TempDir()) / ("thaw_export_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  SurfelSamples surfels;
  Export() {
    fs::remove_all(folder);
    fs::create_directories(folder / "frames");
    sampleBall(surfels, {0, 0, 0.5}, 0.5, 0.05, 3);
    sampleBall(surfels, {2, 0, 0.5}, 0.2, 0.05, 9);
    for (std::size_t i = 0; i < surfels.size(); i++) surfels.temperature[i] = 300 + 100 * surfels.positions[i].z;
  }
  ~Export() override { fs::remove_all(folder); }

  fs::path surfaceFrame(int number) {
    const fs::path path = folder / "frames" / ("wax_surface_00000" + std::to_string(number) + ".hdf");
    writeSurfaceFrame(path.string(), surfels, 0.1 * number);
    return path;
  }
  fs::path particleFrame(int number) {
    const fs::path path = folder / "frames" / ("wax_00000" + std::to_string(number) + ".hdf");
    Frame frame;
    frame.count = surfels.size();
    frame.positions = {"position", "m", Scalar::F32, 3, surfels.positions.data()};
    frame.fields = {{"temperature", "K", Scalar::F32, 1, surfels.temperature.data()}};
    startMpi();
    writeFrame(path.string(), MPI_COMM_SELF, frame, {});
    return path;
  }
  int run(const fs::path& input, const std::string& as, const fs::path& out = {}, const std::string& field = "surface") {
    ExportOptions o;
    o.input = input, o.as = as, o.out = out, o.field = field;
    return exportCommand(o);
  }
};

/// A square of two triangles, and a triangle of another sheet.
fs::path writeSheets(const fs::path& path) {
  const std::vector<Vec3d> places{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}};
  const std::vector<std::uint16_t> bodies{0, 0, 0, 0, 1, 1, 1};
  const std::vector<std::uint8_t> colours(21, 90);
  Frame frame;
  frame.count = places.size();
  frame.meshed = true;
  frame.triangles = {0, 1, 2, 0, 2, 3, 4, 5, 6};
  frame.positions = {"position", "m", Scalar::F64, 3, places.data()};
  frame.fields = {{"sheet_body", "1", Scalar::U16, 1, bodies.data()}, {"color", "1", Scalar::U8, 3, colours.data()}};
  startMpi();
  writeFrame(path.string(), MPI_COMM_SELF, frame, {});
  return path;
}

std::string contentOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

template<class F> std::string errorOf(F what) {
  try {
    what();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_F(Export, PicturesShowInOnePieceWhatCrossesAPeriodicSide) {
  PeriodicSides sides;
  sides.is[0] = true;
  sides.min = {0, -1, 0}, sides.period = {3, 2, 2};
  for (auto& x : surfels.positions)
    if (x.x < 0) x.x += 3;  // half of the first ball
  const fs::path frame = surfaceFrame(1);
  const auto widest = [](const FrameView& view) {
    float least = 10, most = -10;
    for (std::size_t i = 0; i < view.positions.size(); i++)
      if (view.components[i] == 3) least = std::min(least, view.positions[i].x), most = std::max(most, view.positions[i].x);
    return most - least;
  };
  EXPECT_GT(widest(readFrameView(frame, "surface")), 2.9f);
  EXPECT_LT(widest(readFrameView(frame, "surface", sides)), 1.01f);
}

TEST_F(Export, SheetsWithTheirTriangles) {
  const fs::path frame = writeSheets(folder / "frames" / "cloth_sheet_000001.hdf");
  for (const std::string as : {"ply", "obj"}) {
    const fs::path out = folder / ("cloth." + as);
    ASSERT_EQ(run(frame, as, out), 0);
    const TriangleMesh m = readMesh(out.string());
    ASSERT_EQ(m.triangles.size(), 3u);
    EXPECT_EQ(m.vertices.size(), 7u);
    double area = 0;
    for (const auto& t : m.triangles) area += 0.5 * cross(m.vertices[t[1]] - m.vertices[t[0]], m.vertices[t[2]] - m.vertices[t[0]]).z;
    EXPECT_NEAR(area, 1.5, 1e-6);
  }
  ASSERT_EQ(run(frame, "vtp", folder / "cloth.vtp"), 0);
  const std::string vtp = contentOf(folder / "cloth.vtp");
  for (const char* part : {"NumberOfPoints=\"7\"", "NumberOfPolys=\"3\"", "type=\"UInt16\" Name=\"sheet_body\"", "type=\"UInt8\" Name=\"color\" NumberOfComponents=\"3\""})
    EXPECT_NE(vtp.find(part), std::string::npos) << part;
  EXPECT_EQ(run(frame, "pov", folder / "cloth.pov"), 2);
}

/// Two flat rows and a curve of oriented particles, rows in another order: `turn` of them further.
fs::path writeOriented(const fs::path& path, std::size_t turn) {
  std::vector<Vec3d> places;
  std::vector<std::uint32_t> groups;
  std::vector<std::uint64_t> ids;
  for (int k = 0; k < 12; k++) places.push_back({(k / 2) + 0.5 * (k % 2), 0.866 * (k % 2), 0}), groups.push_back(0), ids.push_back(static_cast<std::uint64_t>(k));
  for (int k = 0; k < 5; k++) places.push_back({static_cast<double>(k), 9, 0}), groups.push_back(1), ids.push_back(std::uint64_t(1) << 63 | static_cast<std::uint64_t>(k));
  const auto turned = [&](auto& v) { std::rotate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(turn), v.end()); };
  turned(places), turned(groups), turned(ids);
  const std::size_t n = places.size();
  std::vector<float> turns, radii(n, 1);
  for (std::size_t k = 0; k < n; k++) turns.insert(turns.end(), {1, 0, 0, 0});
  const std::vector<std::uint16_t> bodies(n, 0);
  const std::vector<std::uint64_t> cuts(n, 0);
  const std::vector<std::uint8_t> flags(n, 0);
  Frame frame;
  frame.count = n;
  frame.positions = {"position", "m", Scalar::F64, 3, places.data()};
  frame.fields = {{"id", "1", Scalar::U64, 1, ids.data()}, {"oriented_body", "1", Scalar::U16, 1, bodies.data()}, {"orientation", "1", Scalar::F32, 4, turns.data()},
                  {"radius", "m", Scalar::F32, 1, radii.data()}, {"group", "1", Scalar::U32, 1, groups.data()}, {"cut_sides", "1", Scalar::U64, 1, cuts.data()},
                  {"flags", "1", Scalar::U8, 1, flags.data()}};
  startMpi();
  writeFrame(path.string(), MPI_COMM_SELF, frame, {});
  return path;
}

// Rows lie on the ranks in any order; a curve has no triangles.
TEST_F(Export, OrientedInTheOrderOfIdsWithLinesOfCurves) {
  for (const std::string as : {"ply", "obj", "vtp"}) {
    std::string first;
    for (const std::size_t turn : {0, 5, 13}) {
      const fs::path out = folder / ("o" + std::to_string(turn) + "." + as);
      ASSERT_EQ(run(writeOriented(folder / "frames" / "o_oriented_000001.hdf", turn), as, out), 0);
      const std::string now = contentOf(out);
      if (first.empty()) first = now;
      EXPECT_EQ(now, first) << as << " " << turn;
    }
    const char* has = as == "ply" ? "property uint id_high\nproperty uint id_low\nelement face 10" : as == "obj" ? "\nl 13 14\n" : "NumberOfLines=\"4\" NumberOfStrips=\"0\" NumberOfPolys=\"10\"";
    EXPECT_NE(first.find(has), std::string::npos) << as;
  }
  EXPECT_NE(contentOf(folder / "o0.ply").find("element edge 4\nproperty int vertex1"), std::string::npos);
  EXPECT_EQ(readMesh((folder / "o0.obj").string()).triangles.size(), 10u);
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
  EXPECT_FALSE(readSurfaceFrame(surfaceFrame(1).string(), [](const std::string& n) { return n == "liquid"; }).find("detail"));
  EXPECT_NE(errorOf([&] { readSurfaceFrame(particleFrame(1).string()); }).find("is not a frame of a surface"), std::string::npos);
}

TEST_F(Export, TheSurfaceIsDrawnWhereThereIsOne) {
  const fs::path particles = particleFrame(1);
  EXPECT_EQ(findFrames(folder), std::vector<fs::path>{particles});
  EXPECT_NE(errorOf([&] { findFrames(folder, FrameKind::Surface); }).find("no frames of a surface in this folder, only of particles, sheets or oriented particles"), std::string::npos);
  const fs::path surface = surfaceFrame(1);
  EXPECT_EQ(findFrames(folder), std::vector<fs::path>{surface});
  EXPECT_EQ(findFrames(folder, FrameKind::Particles), std::vector<fs::path>{particles});
  std::ofstream(folder / "frames" / "wax.hdf.series") << R"({"file-series-version":"1.0","files":[{"name":"wax_000001.hdf","time":0.1}]})";
  EXPECT_EQ(findFrames(folder), std::vector<fs::path>{surface});
  std::ofstream(folder / "frames" / "wax_surface.hdf.series") << R"({"file-series-version":"1.0","files":[{"name":"wax_surface_000001.hdf","time":0.1}]})";
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
  for (const char* field : {"surface", "glow", "liquid", "none"}) EXPECT_EQ((o.field = field, renderCommand(o)), 0) << field;
  EXPECT_EQ((o.field = "pressure", renderCommand(o)), 3);
}

TEST_F(Export, MeshesAreReadBack) {
  const fs::path frame = surfaceFrame(1);
  ASSERT_EQ(run(frame, "ply"), 0);
  ASSERT_EQ(run(frame, "obj", folder / "out.obj", "temperature"), 0);
  const TriangleMesh ply = readMesh((folder / "export" / "wax_surface_000001.ply").string()), obj = readMesh((folder / "out.obj").string());
  EXPECT_EQ(ply.triangles, obj.triangles);
  EXPECT_NEAR(volumeOf(ply), 4.18879 * (0.125 + 0.008), 0.01);
  EXPECT_NEAR(volumeOf(obj), volumeOf(ply), 1e-6);
  const std::string text = contentOf(folder / "out.obj");
  EXPECT_NE(text.find("o component_3\n"), std::string::npos);
  EXPECT_NE(text.find("o component_9\n"), std::string::npos);
}

// The sides are those of the scene that the frame keeps.
TEST_F(Export, MeshesAcrossPeriodicSidesAreWholeOrTold) {
  const auto across = [&](const std::string& name, auto addSurfels) {
    SurfelSamples s;
    addSurfels(s);
    for (Vec3f& x : s.positions) x.x -= std::floor(x.x);
    const std::string scene = "# ---- x.toml\nspacing = 0.1\nend = 1\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\nsides = { x = \"periodic\" }\n[material.oil]\n[[body]]\nmaterial = \"oil\"\nsphere = { radius = 0.2 }\nplace = { move = [0.5, 0.5, 0.5] }\n";
    const fs::path frame = folder / "frames" / (name + "_surface_000001.hdf");
    writeSurfaceFrame(frame.string(), s, 0.1, true, scene);
    testing::internal::CaptureStdout();
    EXPECT_EQ(run(frame, "ply", folder / (name + ".ply")), 0);
    return testing::internal::GetCapturedStdout();
  };
  EXPECT_EQ(across("ball", [](SurfelSamples& s) { sampleBall(s, {0.95, 0.5, 0.5}, 0.3, 0.05, 3); }).find("periodic"), std::string::npos);
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
        s.add({rod.positions[i].x, rod.positions[i].y, rod.positions[i].z}, {rod.normals[i].x, rod.normals[i].y, rod.normals[i].z}, 0.05, 3);
  });
  EXPECT_NE(said.find("component 3, which goes round the periodic sides along x, is cut there and capped"), std::string::npos) << said;
  EXPECT_NE(contentOf(folder / "rod.ply").find("comment component 3, which goes round"), std::string::npos);
  EXPECT_NEAR(volumeOf(readMesh((folder / "rod.ply").string())), 0.12, 0.01 * 0.12);
}

TEST_F(Export, CubesWiderThanABodyAreTold) {
  ExportOptions o;
  o.input = surfaceFrame(1), o.as = "ply";
  for (const double cell : {1.0, 10.0}) {
    o.cell = cell;
    testing::internal::CaptureStderr();
    EXPECT_EQ(exportCommand(o), 0);
    const std::string said = testing::internal::GetCapturedStderr();
    if (cell == 1) EXPECT_EQ(said, "");
    else EXPECT_NE(said.find("--cell 10: cubes of 0.5 m are too wide for 2 of 2 components, which are made with finer ones; 0.5 to 2 is sensible"), std::string::npos) << said;
  }
}

TEST_F(Export, DiscsAreWhereTheSurfelsAre) {
  const fs::path frame = surfaceFrame(1);
  ASSERT_EQ(run(frame, "ply-discs"), 0);
  const TriangleMesh m = readMesh((folder / "export" / "wax_surface_000001.discs.ply").string());
  ASSERT_EQ(m.vertices.size(), 8 * surfels.size());
  for (std::size_t i = 0; i < surfels.size(); i += 37)
    for (std::size_t k = 0; k < 8; k++) {
      const Vec3d d = m.vertices[8 * i + k] - Vec3d{surfels.positions[i].x, surfels.positions[i].y, surfels.positions[i].z};
      EXPECT_NEAR(length(d), surfels.radii[i], 1e-6);
      EXPECT_NEAR(d.x * surfels.normals[i].x + d.y * surfels.normals[i].y + d.z * surfels.normals[i].z, 0, 1e-6);
    }
  // Seen from outside the corners go round against the clock.
  for (std::size_t t = 0; t < m.triangles.size(); t += 91) {
    const auto& c = m.triangles[t];
    const Vec3f& n = surfels.normals[c[0] / 8];
    EXPECT_GT(dot(cross(m.vertices[c[1]] - m.vertices[c[0]], m.vertices[c[2]] - m.vertices[c[0]]), Vec3d{n.x, n.y, n.z}), 0);
  }
}

TEST_F(Export, VtpAndPovHoldEverySurfel) {
  const fs::path frame = surfaceFrame(1);
  ASSERT_EQ(run(frame, "vtp"), 0);
  ASSERT_EQ(run(frame, "pov"), 0);
  const std::string vtp = contentOf(folder / "export" / "wax_surface_000001.vtp");
  for (const char* name : {"normal", "radius", "color", "id", "component", "liquid", "temperature", "detail", "connectivity", "offsets", "Points"})
    EXPECT_NE(vtp.find("Name=\"" + std::string(name) + "\""), std::string::npos) << name;
  // The points stand where their element says, behind their length.
  const std::size_t element = vtp.find("Name=\"Points\""), offset = std::stoul(vtp.substr(vtp.find("offset=\"", element) + 8));
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

TEST_F(Export, AllFramesOfARunAndEveryErrorIsSaid) {
  surfaceFrame(0), surfaceFrame(1);
  const fs::path particles = particleFrame(0);
  EXPECT_EQ(run(folder, "ply", folder / "meshes"), 0);
  EXPECT_TRUE(fs::exists(folder / "meshes" / "wax_surface_000000.ply") && fs::exists(folder / "meshes" / "wax_surface_000001.ply"));
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

TEST_F(Export, AFilmIsMadeOrTheCommandSaid) {
  const std::vector<fs::path> pictures{folder / "a_000001.png", folder / "a_000002.png"};
  for (const fs::path& p : pictures) writePng(Image(65, 41, {200, 100, 0}), p);
  const std::string command = movieCommand(pictures, folder / "a.mp4", 25);
  EXPECT_NE(command.find("-i '" + (folder / "a_*.png").string() + "'"), std::string::npos) << command;
  if (isInstalled("ffmpeg")) {
    makeMovie(pictures, folder / "a.mp4", 25);
    EXPECT_GT(fs::file_size(folder / "a.mp4"), 500u);
    std::ofstream(folder / "bad_000001.png") << "no picture";
    EXPECT_NE(errorOf([&] { makeMovie({folder / "bad_000001.png"}, folder / "bad.mp4", 25); }).find("ffmpeg failed"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "bad.mp4"));
  } else {
    EXPECT_NE(errorOf([&] { makeMovie(pictures, folder / "a.mp4", 25); }), "no error");
  }
}
