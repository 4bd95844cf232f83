// SPDX-License-Identifier: Apache-2.0
// Contents of exports: fields of particles on surfaces, positions of obstacles, bgeo read back by a reader
// in this file, and invalid requests.
#include <bit>
#include <cstring>

#include "io/export/polylines.hpp"
#include "io/export/vtkhdf_series.hpp"
#include "io/meshes/read_mesh.hpp"
#include "tests/support/export_fixture.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

constexpr const char* sceneText =
    "# ---- x.toml\nspacing = 0.1\nend = 1\n[domain]\nmin = [-3, -3, 0]\nmax = [3, 3, 3]\n[material.oil]\n"
    "[[body]]\nmaterial = \"oil\"\nsphere = { radius = 0.2 }\nplace = { move = [0.5, 0.5, 0.5] }\n"
    "[[obstacle]]\nname = \"floor\"\nplane = { point = [0, 0, 0.1], normal = [0, 0, 1] }\n"
    "[[obstacle]]\nname = \"lid\"\nbox = { size = [1, 1, 0.5] }\nplace = { move = [0, 0, 2] }\n"
    "motion = [{ time = 0 }, { time = 1, move = [0, 0, 1] }]\n";

/// Reads Houdini geometry as its documentation describes it.
struct Bgeo {
  struct Attribute {
    std::string name;
    int size = 0, type = 0;
  };
  std::string bytes;
  std::size_t at = 0;
  std::vector<Attribute> attributes;
  std::vector<std::vector<float>> points;  ///< x y z w, then all attributes; integers as numbers
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::vector<std::uint32_t>> curves;

  std::uint32_t number(int size) {
    std::uint32_t v = 0;
    for (int k = 0; k < size; k++) v = v << 8 | static_cast<unsigned char>(bytes.at(at++));
    return v;
  }
  explicit Bgeo(const fs::path& file) : bytes(contentOf(file)) {
    EXPECT_EQ(bytes.substr(0, 5), "BgeoV");
    at = 5;
    EXPECT_EQ(number(4), 5u);
    std::uint32_t count[8];
    for (auto& c : count) c = number(4);
    for (std::uint32_t k = 0; k < count[4]; k++) {
      Attribute a;
      const std::uint32_t length = number(2);
      a.name = bytes.substr(at, length);
      at += length;
      a.size = static_cast<int>(number(2)), a.type = static_cast<int>(number(4));
      at += 4 * static_cast<std::size_t>(a.size);
      attributes.push_back(a);
    }
    for (std::uint32_t k = 0; k < count[0]; k++) points.push_back(point());
    while (triangles.size() + curves.size() < count[1]) readRun(count[0] > 0xffff ? 4 : 2);
    EXPECT_EQ(bytes.substr(at), std::string("\x00\xff", 2));
  }
  std::vector<float> point() {
    std::vector<float> p;
    for (int c = 0; c < 4; c++) p.push_back(std::bit_cast<float>(number(4)));
    for (const Attribute& a : attributes)
      for (int c = 0; c < a.size; c++) {
        const std::uint32_t v = number(4);
        p.push_back(a.type == 1 ? static_cast<float>(static_cast<std::int32_t>(v)) : std::bit_cast<float>(v));
      }
    return p;
  }
  void readRun(int width) {
    ASSERT_EQ(number(4), 0xffffffffu);
    const std::uint32_t polygons = number(2);
    ASSERT_EQ(number(4), 1u);
    for (std::uint32_t k = 0; k < polygons; k++) {
      const std::uint32_t corners = number(4);
      if (bytes.at(at++) == ':') {  // open
        curves.emplace_back();
        for (std::uint32_t c = 0; c < corners; c++) curves.back().push_back(number(width));
        continue;
      }
      ASSERT_EQ(corners, 3u);
      ASSERT_EQ(bytes.at(at - 1), '<');
      triangles.push_back({number(width), number(width), number(width)});
    }
  }
  std::size_t column(const std::string& name) const {
    std::size_t c = 4;
    for (const Attribute& a : attributes) {
      if (a.name == name) return c;
      c += static_cast<std::size_t>(a.size);
    }
    ADD_FAILURE() << "no attribute " << name;
    return 0;
  }
};

}  // namespace

/// Frames of a surface and of moving particles at the same time.
class ExportContents : public Export {
 protected:
  fs::path both(int number, double time) {
    fs::path path = folder / "frames" / ("wax_surface_00000" + std::to_string(number) + ".hdf");
    writeSurfaceFrame(path.string(), surfels, time, true, sceneText);
    std::vector<Vec3f> velocities;
    std::vector<std::uint64_t> ids;
    for (const Vec3f& x : surfels.positions)
      velocities.push_back({x.x, 2, 0}), ids.push_back(velocities.size() - 1);
    Frame frame;
    frame.time = time;
    frame.count = surfels.size();
    frame.positions = {"position", "m", Scalar::F32, 3, surfels.positions.data()};
    frame.fields = {{"id", "1", Scalar::U64, 1, ids.data()},
                    {"velocity", "m/s", Scalar::F32, 3, velocities.data()}};
    startMpi();
    writeFrame((folder / "frames" / ("wax_00000" + std::to_string(number) + ".hdf")).string(), MPI_COMM_SELF,
               frame, {});
    return path;
  }
  int write(const fs::path& input, const std::string& as, const std::string& what, const fs::path& out) {
    ExportOptions o;
    o.input = input, o.as = as, o.out = out, o.what = what;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = exportCommand(o);
    said = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
    return code;
  }
  std::string said;
};

TEST_F(ExportContents, MeshesCarryVelocitiesOfParticles) {
  const fs::path frame = both(1, 0.1);
  ASSERT_EQ(write(frame, "ply", "", folder / "a.ply"), 0);
  EXPECT_NE(
      contentOf(folder / "a.ply")
          .find("property float velocity_x\nproperty float velocity_y\nproperty float velocity_z\nproperty "
                "float temperature\nproperty float liquid\n"),
      std::string::npos);
  EXPECT_NEAR(volumeOf(readMesh((folder / "a.ply").string())), 4.18879 * (0.125 + 0.008), 0.01);
  ASSERT_EQ(write(frame, "vtp", "", folder / "a.vtp"), 0);
  EXPECT_NE(contentOf(folder / "a.vtp").find("Name=\"velocity\" NumberOfComponents=\"3\""),
            std::string::npos);
}

TEST_F(ExportContents, BgeoHoldsMeshesAndParticles) {
  ASSERT_EQ(write(both(1, 0.1), "bgeo", "surface,particles", folder / "a.bgeo"), 0) << said;
  const Bgeo geo(folder / "a.bgeo");
  const std::size_t v = geo.column("v"), id = geo.column("id"), scale = geo.column("pscale"),
                    n = geo.column("N"), heat = geo.column("temperature");
  std::size_t particles = 0;
  for (const auto& p : geo.points) {
    EXPECT_EQ(p[3], 1);
    EXPECT_NEAR(p[v], p[0], 0.06);
    EXPECT_NEAR(p[v + 1], 2, 1e-5);
    if (p[id] < 0) {  // a vertex
      EXPECT_NEAR(p[n] * p[n] + p[n + 1] * p[n + 1] + p[n + 2] * p[n + 2], 1, 1e-3);
      EXPECT_NEAR(p[heat], 300 + 100 * p[2], 4);
      continue;
    }
    EXPECT_EQ(p[id], static_cast<float>(particles++));
    EXPECT_FLOAT_EQ(p[scale], 0.05f);
  }
  EXPECT_EQ(particles, surfels.size());
  double volume = 0;
  for (const auto& t : geo.triangles) {
    const auto place = [&](std::uint32_t k) {
      const auto& p = geo.points.at(k);
      return Vec3d{p[0], p[1], p[2]};
    };
    volume -= dot(place(t[0]), cross(place(t[1]), place(t[2]))) / 6;  // clockwise from outside
  }
  EXPECT_NEAR(volume, 4.18879 * (0.125 + 0.008), 0.01);
}

TEST_F(ExportContents, BgeoHoldsCurvesAsOpenPolygons) {
  const fs::path frame = writeOriented(folder / "frames" / "o_oriented_000001.hdf", 0);
  ASSERT_EQ(write(frame, "bgeo", "oriented", folder / "o.bgeo"), 0) << said;
  const Bgeo geo(folder / "o.bgeo");
  EXPECT_EQ(geo.triangles.size(), 10u);
  ASSERT_EQ(geo.curves, (std::vector<std::vector<std::uint32_t>>{{12, 13, 14, 15, 16}}));
  for (std::uint32_t k = 0; k < 5; k++) EXPECT_EQ(geo.points.at(12 + k)[0], static_cast<float>(k));
}

TEST_F(ExportContents, VtkHdfHasLinesBetweenTrianglesAndParticles) {
  ExportScene scene;
  ComponentMesh curve, triangle;
  curve.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  curve.lines = {{0, 1}, {1, 2}};
  triangle.mesh.vertices = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  triangle.mesh.triangles = {{0, 1, 2}};
  scene.objects.push_back({"oriented", ExportKind::Oriented, {curve, triangle}, {}, false});
  scene.points.emplace();
  scene.points->positions = {{5, 5, 5}};
  const VtkHdfFrame f = vtkHdfFrameOf(scene);
  EXPECT_EQ(f.triangles, 1);
  EXPECT_EQ(f.lines, 2);
  EXPECT_EQ(f.connectivity, (std::vector<std::int64_t>{3, 4, 5, 0, 1, 1, 2, 6}));
}

TEST(Polylines, CoverEachLineOnce) {
  using Runs = std::vector<std::vector<std::uint32_t>>;
  using Lines = std::vector<std::array<std::uint32_t, 2>>;
  EXPECT_EQ(polylinesOf(Lines{{2, 1}, {0, 1}, {2, 3}}), (Runs{{0, 1, 2, 3}}));
  EXPECT_EQ(polylinesOf(Lines{{0, 1}, {1, 2}, {2, 0}}), (Runs{{0, 1, 2, 0}})) << "closed";
  EXPECT_EQ(polylinesOf(Lines{{0, 1}, {1, 2}, {1, 3}, {4, 5}}), (Runs{{0, 1}, {1, 2}, {1, 3}, {4, 5}}))
      << "a branch";
  EXPECT_TRUE(polylinesOf(Lines{}).empty());
}

// Labels of components are ids of particles, which contain the body.
TEST_F(ExportContents, ComponentsHaveTheNameOfTheirBody) {
  ASSERT_EQ(write(both(1, 0.1), "obj", "surface", folder / "a.obj"), 0) << said;
  const std::string obj = contentOf(folder / "a.obj");
  EXPECT_NE(obj.find("o body 0\n"), std::string::npos);
  EXPECT_NE(obj.find("o body 0_9\n"), std::string::npos) << "the second piece";
  ASSERT_EQ(write(both(1, 0.1), "ply", "surface", folder / "a.ply"), 0) << said;
  EXPECT_NE(contentOf(folder / "a.ply").find("comment component 9 (body 0_9)\n"), std::string::npos);
}

TEST_F(ExportContents, GlassIsTransparentInUsd) {
  const fs::path frame = both(1, 0.1);
  const auto layer = [&](const std::string& look) {
    std::string text = sceneText;
    text.replace(text.find("motion ="), 0, "look = \"" + look + "\"\n");
    writeSurfaceFrame(frame.string(), surfels, 0.1, true, text);
    EXPECT_EQ(write(frame, "usda", "obstacles", folder / "a.usda"), 0) << said;
    return contentOf(folder / "a.usda");
  };
  EXPECT_NE(layer("glass").find("float[] primvars:displayOpacity"), std::string::npos);
  EXPECT_EQ(layer("solid").find("displayOpacity"), std::string::npos) << "the plane is a floor";
}

TEST_F(ExportContents, ObstaclesAreAtTheirPlace) {
  const fs::path frame = both(1, 0.5);
  for (const std::string as : {"ply", "obj"}) {
    ASSERT_EQ(write(frame, as, "obstacles", folder / ("o." + as)), 0) << said;
    const TriangleMesh m = readMesh((folder / ("o." + as)).string());
    double low = 10, high = 0;
    for (const Vec3d& x : m.vertices) low = std::min(low, x.z), high = std::max(high, x.z);
    EXPECT_NEAR(low, 0.1, 1e-6);
    EXPECT_NEAR(high, 2 + 0.25 + 0.5, 1e-6);
    EXPECT_NEAR(areaOf(m), 36 + 4, 1e-4);
  }
  EXPECT_NE(contentOf(folder / "o.obj").find("o lid\n"), std::string::npos);
  ASSERT_EQ(write(frame, "usda", "all", folder / "o.usda"), 0) << said;
  const std::string text = contentOf(folder / "o.usda");
  for (const char* part :
       {"def Mesh \"floor\"", "def Mesh \"lid\"", "def Mesh \"surface\"", "def Points \"particles\"",
        "def Camera \"camera\"", "(0, 0, 0.5, 1) )", "timeCodesPerSecond = 25\n"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  ASSERT_EQ(write(frame, "usda", "", folder / "s.usda"), 0) << said;
  EXPECT_EQ(contentOf(folder / "s.usda").find("particles"), std::string::npos);
}

TEST_F(ExportContents, WrongRequestsAreReported) {
  const fs::path frame = both(1, 0.1);
  EXPECT_EQ(write(frame, "ply", "surface,foam", folder / "a.ply"), 2);
  EXPECT_NE(said.find("--what: expected surface, sheet, oriented, obstacles, particles or all"),
            std::string::npos)
      << said;
  EXPECT_EQ(write(frame, "ply", "particles", folder / "a.ply"), 2);
  EXPECT_NE(said.find("particles are exported as usd, usda, vtkhdf, bgeo, vdb or html, not as ply"),
            std::string::npos)
      << said;
  EXPECT_EQ(write(frame, "usd", "", folder / "a.ply"), 2);
  EXPECT_NE(said.find("--out: expected a folder or a file that ends in .usdc or .usd"), std::string::npos)
      << said;
  EXPECT_EQ(write(folder, "usd", "sheet", folder / "a.usdc"), 3);
  if (fs::exists("/dev/full")) {
    for (const char* name : {"full.usdc", "full.usda", "full.bgeo"}) {
      fs::create_symlink("/dev/full", folder / (std::string(name) + ".part"));
      EXPECT_EQ(write(frame,
                      fs::path(name).extension().string().substr(1) == "usdc" ? "usd"
                      : fs::path(name).extension() == ".usda"                 ? "usda"
                                                                              : "bgeo",
                      "", folder / name),
                3);
      EXPECT_FALSE(fs::exists(folder / name)) << name;
    }
  }
}

// The plate has no temperature and no velocity. Its values are padded, and the ball keeps its fields.
TEST_F(ExportContents, MeshesKeepTheirFieldsBesideObstacles) {
  const fs::path frame = both(1, 0.5);
  ASSERT_EQ(write(frame, "ply", "surface,obstacles", folder / "a.ply"), 0) << said;
  const std::string ply = contentOf(folder / "a.ply");
  for (const char* part : {"property float velocity_x\n", "property float temperature\n",
                           "property int object\n", "comment object floor\n"})
    EXPECT_NE(ply.find(part), std::string::npos) << part;
  ASSERT_EQ(write(frame, "vtp", "surface,obstacles", folder / "a.vtp"), 0) << said;
  const std::string vtp = contentOf(folder / "a.vtp");
  const auto floats = [&](const char* name) {
    const std::size_t element = vtp.find("Name=\"" + std::string(name) + "\"");
    EXPECT_NE(element, std::string::npos) << name;
    const std::size_t offset = std::stoul(vtp.substr(vtp.find("offset=\"", element) + 8));
    const char* block = vtp.data() + vtp.find("<AppendedData encoding=\"raw\">\n_") + 31 + offset;
    std::uint64_t bytes;
    std::memcpy(&bytes, block, 8);
    std::vector<float> values(bytes / sizeof(float));
    std::memcpy(values.data(), block + 8, bytes);
    return values;
  };
  const std::vector<float> warm = floats("temperature"), velocities = floats("velocity");
  ASSERT_EQ(3 * warm.size(), velocities.size());
  std::size_t without = 0, still = 0;
  for (std::size_t v = 0; v < warm.size(); v++) {
    without += std::isnan(warm[v]);
    still += velocities[3 * v] == 0 && velocities[3 * v + 1] == 0 && velocities[3 * v + 2] == 0;
    if (!std::isnan(warm[v])) { EXPECT_NEAR(velocities[3 * v + 1], 2, 1e-3); }
  }
  EXPECT_GT(without, 8u);
  EXPECT_GT(warm.size(), 2 * without);
  EXPECT_GT(still, 3u);  // the floor
}

TEST_F(ExportContents, VtpHasClosedMeshesOnRequest) {
  ExportOptions o;
  o.input = both(1, 0.5), o.as = "vtp", o.out = folder / "a.vtp", o.mesh = true;
  EXPECT_EQ(exportCommand(o), 0);
  const std::string vtp = contentOf(folder / "a.vtp");
  EXPECT_NE(vtp.find("NumberOfVerts=\"0\""), std::string::npos);
  for (const char* name : {"velocity", "temperature", "component"})
    EXPECT_NE(vtp.find("Name=\"" + std::string(name) + "\""), std::string::npos) << name;
  o.as = "ply";
  EXPECT_EQ(exportCommand(o), 2);
}
