// SPDX-License-Identifier: Apache-2.0
// The restart record against the table of keys.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "core/terms/extensions.hpp"
#include "io/scene/tables/read_sections.hpp"

namespace thaw {
namespace {

constexpr ShapeKind shapes[] = {
    ShapeKind::Box,   ShapeKind::Sphere, ShapeKind::Cylinder, ShapeKind::Torus,      ShapeKind::HalfSpace,
    ShapeKind::Glass, ShapeKind::Mesh,   ShapeKind::Union,    ShapeKind::Difference, ShapeKind::Intersection};

Shape shapeOf(ShapeKind kind) {
  Shape s;
  s.kind = kind;
  if (kind == ShapeKind::Mesh) s.mesh = "a.ply";
  if (kind >= ShapeKind::Union) s.parts.resize(2);
  s.fitHeight = 1;
  s.bottom = Vec3d{};
  return s;
}

void addBodies(Scene& s) {
  const auto value = [](const Vec3d&) { return 1.0; };
  for (const ShapeKind kind : shapes) {
    Body& b = s.bodies.emplace_back();
    b.shape = shapeOf(kind);
    b.clamp.resize(1);
    b.velocityField.linear = true;
  }
  for (const bool disc : {true, false}) {
    Emitter& e = s.emitters.emplace_back();
    e.disc = disc;
    e.velocityField.linear = true;
    e.velocityField.component[0] = {"x", "", {}, value};
  }
  Obstacle& o = s.obstacles.emplace_back();
  o.temperature = 300;
  o.motion.resize(1);
  s.thermostats.emplace_back().material = 0;
  s.lamps.emplace_back().motion.resize(1);
  s.lasers.emplace_back().motion.resize(1);
  HeatedRegion& region = s.heatedRegions.emplace_back();
  region.material = 0;
  region.motion.resize(1);
}

void addSheets(Scene& s) {
  for (const SheetMesh mesh : {SheetMesh::Grid, SheetMesh::Sphere, SheetMesh::Head, SheetMesh::Dome,
                               SheetMesh::Forehead, SheetMesh::File}) {
    SheetBody& b = s.sheets.emplace_back();
    b.mesh = mesh;
    if (mesh == SheetMesh::File) b.shape.mesh = "a.ply";
    b.shape.fitHeight = 1;
    b.shape.bottom = Vec3d{};
    b.shrinkWrapTo = "NAME";
    b.clamp.resize(1);
    b.regions.resize(1);
    b.pressureBrushes.resize(1);
    b.pressureBrushes[0].motion.resize(1);
    b.pressureBrushes[0].inTime.points = {{0, 1}};
    for (FactorInTime& f : b.inTime) f.points = {{0, 1}};
  }
}

void addOriented(Scene& s) {
  for (const OrientedSource source :
       {OrientedSource::Surface, OrientedSource::Patch, OrientedSource::Disc, OrientedSource::Points,
        OrientedSource::Control, OrientedSource::Curve}) {
    OrientedBody& b = s.oriented.emplace_back();
    b.source = source;
    b.points = b.normals = {{0, 0, 1}};
    b.constraints.resize(1);
    b.constraints[0].motion.resize(1);
    b.fields.resize(1);
    b.fields[0].everywhere = false;
    b.fields[0].inTime.points = {{0, 1}};
    for (const auto& [kind, tool] :
         {std::pair{OrientedEventKind::Cut, CutTool::Plane}, std::pair{OrientedEventKind::Cut, CutTool::Line},
          std::pair{OrientedEventKind::Crease, CutTool::Plane},
          std::pair{OrientedEventKind::Smooth, CutTool::Box}}) {
      OrientedEvent& e = b.events.emplace_back();
      e.kind = kind;
      e.tool = tool;
      e.path = {{0, 0, 0}, {0, 0, 1}};
      e.other = "NAME";
    }
  }
}

/// A scene with all keys. Its named elements have one name.
Scene wholeScene() {
  Scene s;
  for (int k = 0; k < 2; k++) {
    Material& m = s.materials.emplace_back();
    m.solidus = m.liquidus = 300;
    if (k == 1) m.viscosityTable = {{300, 1}};
    m.evaporation = {{300, 1e-3}};
    m.flowLaw.law = FlowLaw::Bingham;
    m.flowLaw.yieldStress = m.flowLaw.consistency = {{0, 1}};
    if (k == 1) m.flowLaw.yieldStress = {{300, 2}, {400, 1}};
  }
  s.surface.on = true;
  addBodies(s);
  addSheets(s);
  addOriented(s);
  const auto name = [](auto& list) {
    for (auto& element : list) element.name = "NAME";
  };
  for (const std::string& law : lawNames()) s.materials.emplace_back().law.name = law;
  name(s.materials), name(s.bodies), name(s.emitters), name(s.obstacles), name(s.sheets), name(s.oriented);
  for (const std::string& table : extensionNames([](const Extension& e) { return e.usesTable(); }))
    s.extensions.push_back({table, {}});
  s.extensions.push_back({"NAME", {}});
  return s;
}

/// Returns ".table.key." without names and numbers of elements.
std::string pathOf(const KeyDescription& k) {
  std::string path = ".", part;
  for (const char c : k.table + "." + k.key + ".")
    if (c != '.') part += c;
    else {
      const bool number = std::isdigit(static_cast<unsigned char>(part[0])) != 0;
      if (!part.empty() && part != "NAME" && !number) path += part + ".";
      part.clear();
    }
  return path;
}

bool isTable(const KeyDescription& k) {
  return k.range == "table" || k.range == "list of tables" || k.range == "tables by name";
}

TEST(RecordedKeys, EveryKeyDeclaresTheEffectOfAChange) {
  for (const KeyDescription& k : sceneKeys())
    EXPECT_TRUE(k.restart || isTable(k) || k.table.starts_with("SHAPE")) << k.table << " " << k.key;
}

TEST(RecordedKeys, EveryKeyIsRecordedOrDeclaredFree) {
  std::set<std::string> recorded;
  for (const KeyDescription& k : sceneValues(wholeScene())) recorded.insert(pathOf(k));
  const auto isRecorded = [&](const std::string& path, bool inShape) {
    return std::ranges::any_of(recorded, [&](const std::string& r) {
      return inShape ? r.find(path) != std::string::npos : r.starts_with(path);
    });
  };
  for (const KeyDescription& k : sceneKeys()) {
    const bool inShape = k.table.starts_with("SHAPE");
    std::string path = pathOf(k);
    if (inShape) path = path.substr(6);
    if (k.key == "SHAPE") path = path.substr(0, path.size() - 6) + "box.";
    if (isTable(k) && !k.restart) continue;
    EXPECT_EQ(isRecorded(path, inShape), k.restart != Restart::Free) << k.table << " " << k.key;
  }
}

TEST(RecordedKeys, ValuesAreThoseOfTheScene) {
  Scene s = wholeScene();
  s.materials[0].young = {2e5, 1e3};
  s.thermostats[0].temperature = 321;
  const std::vector<KeyDescription> keys = sceneValues(s);
  const auto valueOf = [&](const std::string& path) {
    const auto at = std::ranges::find_if(
        keys, [&](const KeyDescription& k) { return k.table + "." + k.key == path; });
    return at == keys.end() ? "" : at->standard;
  };
  EXPECT_EQ(valueOf("material.NAME.young"), "{ solid = 200000, liquid = 1000 }");
  EXPECT_EQ(valueOf("thermostat.0.temperature"), "321");
  EXPECT_EQ(valueOf("thermostat.0.material"), "\"NAME\"");
  EXPECT_EQ(valueOf("emitter.NAME.velocity"), "[\"x\", 0, 0]");
  EXPECT_EQ(valueOf("sheet.NAME.warp_in_time"), "[[0, 1]]");
  EXPECT_EQ(valueOf("oriented.NAME.event.2.along"), "[[0, 0, 0], [0, 0, 1]]");
}

TEST(RecordedKeys, LongListsAreChecksums) {
  Scene s;
  s.oriented.emplace_back().source = OrientedSource::Points;
  s.oriented[0].points.resize(1000);
  s.obstacles.resize(1);
  s.obstacles[0].motion.resize(500);
  std::size_t frames = 0;
  for (const KeyDescription& k : sceneValues(s)) {
    EXPECT_LE(k.standard.size(), 200u) << k.key;
    frames += k.table.find("motion") != std::string::npos;
  }
  EXPECT_EQ(frames, 300u);
}

}  // namespace
}  // namespace thaw
