// SPDX-License-Identifier: Apache-2.0
#include "io/run/restart/restart_record.hpp"

#include <gtest/gtest.h>

#include "io/run/restart/mesh_fingerprints.hpp"

namespace thaw {
namespace {

Scene sample() {
  Scene s;
  s.spacing = 0.01;
  s.materials.resize(2);
  s.materials[0].name = "wax";
  s.materials[1].name = "oil";
  s.bodies.resize(1);
  s.bodies[0].name = "bust";
  s.emitters.resize(1);
  s.emitters[0].name = "tap";
  return s;
}

TEST(RestartRecord, AllowedChangesAreAccepted) {
  const CheckpointValues then = restartRecordOf(sample());
  Scene s = sample();
  EXPECT_TRUE(restartConflicts(then, s).empty());
  s.end = 7;
  s.materials[0].density = 1234;
  s.output.checkpoint = 1;
  s.output.fields = {"id"};
  s.numerics.cflSound = 0.1;
  s.emitters[0].end = 3;
  s.obstacles.resize(1);
  EXPECT_TRUE(restartConflicts(then, s).empty());
}

TEST(RestartRecord, OtherChangesAreRefused) {
  const CheckpointValues then = restartRecordOf(sample());
  const auto refused = [&](auto&& change) {
    Scene s = sample();
    change(s);
    return !restartConflicts(then, s).empty();
  };
  EXPECT_TRUE(refused([](Scene& s) { s.spacing = 0.02; }));
  EXPECT_TRUE(refused([](Scene& s) { s.numerics.support = 2.5; }));
  EXPECT_TRUE(refused([](Scene& s) { s.output.every = 0.1; }));
  EXPECT_TRUE(refused([](Scene& s) { s.domain.max.z = 2; }));
  EXPECT_TRUE(refused([](Scene& s) { s.domain.gravity.z = 0; }));
  EXPECT_TRUE(refused([](Scene& s) { s.domain.side[1] = {Side::Periodic, Side::Periodic}; }));
  EXPECT_TRUE(refused([](Scene& s) { std::swap(s.materials[0], s.materials[1]); }));
  EXPECT_TRUE(refused([](Scene& s) { s.bodies[0].name = "cube"; }));
  EXPECT_TRUE(refused([](Scene& s) { s.bodies.clear(); }));
  EXPECT_TRUE(refused([](Scene& s) { s.emitters[0].rate = 2; }));
}

TEST(RestartRecord, BodyTypeCoefficientsMayChangeAndAreReported) {
  Scene s = sample();
  s.sheets.emplace_back().name = "cloth";
  s.oriented.emplace_back().name = "film";
  const CheckpointValues then = restartRecordOf(s);
  EXPECT_TRUE(coefficientChanges(then, s).empty());
  s.sheets[0].warp = 7;
  s.sheets[0].pressureBrushes.emplace_back();
  s.oriented[0].circle = 2;
  EXPECT_TRUE(restartConflicts(then, s).empty());
  const std::vector<std::string> changes = coefficientChanges(then, s);
  ASSERT_GE(changes.size(), 3u);
  EXPECT_EQ(changes[0], "oriented.film.cocircular: 1 -> 2");
  EXPECT_EQ(changes[1], "sheet.cloth.warp: 0 -> 7 N/m");
  s.sheets[0].mass = 9;  // existing vertices keep their mass
  EXPECT_FALSE(restartConflicts(then, s).empty());
}

TEST(RestartRecord, SourcesOfOrientedBodiesMayNotChange) {
  Scene s = sample();
  s.oriented.emplace_back().name = "film";
  s.oriented[0].source = OrientedSource::Patch;
  s.oriented[0].constraints.emplace_back();
  s.oriented.emplace_back().name = "net";
  s.oriented[1].source = OrientedSource::Points;
  s.oriented[1].points = {{0, 0, 0}, {1, 0, 0}};
  const CheckpointValues then = restartRecordOf(s);
  const auto refused = [&](auto&& change, std::size_t body = 0) {
    Scene other = s;
    change(other.oriented[body]);
    return !restartConflicts(then, other).empty();
  };
  EXPECT_FALSE(refused([](OrientedBody&) {}));
  EXPECT_TRUE(refused([](OrientedBody& b) { b.width = 2; }));
  EXPECT_TRUE(refused([](OrientedBody& b) { b.thin = 0.5; }));
  EXPECT_TRUE(refused([](OrientedBody& b) { b.density = 2; }));  // existing particles keep their density
  EXPECT_TRUE(refused([](OrientedBody& b) { b.points[1].z = 1; }, 1));
  EXPECT_TRUE(refused([](OrientedBody& b) { b.shape.move.x = 1; }));
  EXPECT_TRUE(refused([](OrientedBody& b) { b.constraints[0].region.move.x = 1; }));
  EXPECT_TRUE(refused([](OrientedBody& b) { b.constraints[0].normal = true; }));
}

TEST(RestartRecord, AreReportedInTheWordsOfTheScene) {
  Scene s = sample();
  s.oriented.emplace_back().name = "film";
  s.oriented[0].source = OrientedSource::Control;
  s.oriented[0].points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  s.sheets.emplace_back().name = "shell";
  s.sheets.back().elasticLimit = 0.01;
  const CheckpointValues then = restartRecordOf(s);
  s.oriented[0].points.push_back({1, 1, 0});
  s.sheets.back().elasticLimit = never;
  const std::vector<std::string> made = restartConflicts(then, s), changes = coefficientChanges(then, s);
  EXPECT_EQ(made, std::vector<std::string>{"oriented.film.control: [[0, 0, 0], [1, 0, 0], [0, 1, 0]] -> "
                                           "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]] m"});
  EXPECT_EQ(changes, std::vector<std::string>{"sheet.shell.elastic_limit: 0.01 m -> \"never\""});
}

TEST(RestartRecord, InitialStatesAreReportedAsWithoutEffect) {
  Scene s = sample();
  for (Material& m : s.materials) m.soundSpeed = 10;
  s.oriented.emplace_back().name = "film";
  const CheckpointValues then = restartRecordOf(s);
  EXPECT_TRUE(initialStateChanges(then, s).empty());
  s.oriented[0].relax = 7;
  s.bodies[0].velocity.x = 3;
  EXPECT_TRUE(restartConflicts(then, s).empty());
  EXPECT_TRUE(coefficientChanges(then, s).empty());
  const std::vector<std::string> changes = initialStateChanges(then, s);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0], "body.bust.velocity: [0, 0, 0] -> [3, 0, 0] m/s");
  EXPECT_EQ(changes[1], "oriented.film.relax: 0 -> 7");
}

TEST(RestartRecord, AutomaticSoundSpeedIsACoefficient) {
  Scene s = sample();
  s.domain.gravity = {};
  const CheckpointValues then = restartRecordOf(s);
  s.bodies[0].velocity.x = 3;
  const std::vector<std::string> changes = coefficientChanges(then, s);
  EXPECT_EQ(changes, std::vector<std::string>{"numerics.expected_speed: 1 -> 3 m/s"});
}

TEST(RestartRecord, MaterialCoefficientsAreReported) {
  Scene s = sample();
  const CheckpointValues then = restartRecordOf(s);
  s.materials[0].young.solid = 2e5;
  EXPECT_EQ(coefficientChanges(then, s),
            std::vector<std::string>{"material.wax.young: 0 -> { solid = 200000, liquid = 0 } Pa"});
}

TEST(RestartRecord, ClampsMayNotChange) {
  Scene s = sample();
  s.sheets.emplace_back().name = "cloth";
  s.sheets[0].clamp.emplace_back();
  const CheckpointValues then = restartRecordOf(s);
  Scene let = s;
  let.sheets[0].clamp.clear();
  EXPECT_FALSE(restartConflicts(then, let).empty());
  Scene clamped = s;
  clamped.bodies[0].clamp.emplace_back();
  EXPECT_FALSE(restartConflicts(then, clamped).empty());
  EXPECT_FALSE(restartConflicts(restartRecordOf(clamped), s).empty());
  clamped.bodies[0].clamp[0].move.z = 1;
  EXPECT_TRUE(initialStateChanges(restartRecordOf(clamped), clamped).empty());
}

TEST(RestartRecord, SurfaceSettingsAreReported) {
  Scene s = sample();
  s.surface.on = true;
  const CheckpointValues then = restartRecordOf(s);
  s.surface.adapt = 0.5;
  s.surface.source = SurfelSource::Particles;
  EXPECT_EQ(settingChanges(then, s, 0).size(), 1u);
  EXPECT_TRUE(coefficientChanges(then, s).empty());  // forces are not recomputed for it
  EXPECT_EQ(initialStateChanges(then, s).size(), 1u);
}

/// Choices are reported by the words of the scene file.
TEST(RestartRecord, ChoicesAreReportedByTheirWords) {
  Scene s = sample();
  s.surface.on = true;
  s.sheets.emplace_back().name = "cloth";
  s.oriented.emplace_back().name = "film";
  s.oriented[0].constraints.emplace_back();
  s.oriented[0].events.emplace_back().kind = OrientedEventKind::Weld;
  s.oriented[0].fields.emplace_back();
  const CheckpointValues then = restartRecordOf(s);
  Scene other = s;
  other.numerics.heat = HeatModel::Paper;
  other.domain.side[0] = {Side::Periodic, Side::Periodic};
  other.emitters[0].material = 1;
  other.sheets[0].mesh = SheetMesh::Sphere;
  other.oriented[0].source = OrientedSource::Disc;
  other.oriented[0].constraints[0].normal = true;
  std::swap(other.materials[0], other.materials[1]);
  EXPECT_EQ(
      restartConflicts(then, other),
      (std::vector<std::string>{
          "body.bust.material: \"wax\" -> \"oil\"", "domain.sides.x: not periodic -> periodic",
          // The tap's material keeps its name and has another place.
          "material.oil: 1 -> 0 (place in the list)", "material.wax: 0 -> 1 (place in the list)",
          "numerics.heat: \"enthalpy\" -> \"paper\"", "oriented.film.box.size is not in the scene any more",
          "oriented.film.constraint.0.normal: false -> true",
          "sheet.cloth.grid.depth is not in the scene any more",
          "sheet.cloth.grid.width is not in the scene any more",
          "oriented.film.disc.radius was not in the scene then",
          "sheet.cloth.sphere.radius was not in the scene then"}));
  other = s;
  other.surface.merge = MergeRule::None;
  other.surface.smoothing = SmoothingForm::Plane;
  other.oriented[0].growth = OrientedGrowth::Borders;
  other.oriented[0].events[0].kind = OrientedEventKind::Crease;
  EXPECT_EQ(settingChanges(then, other, -1),
            (std::vector<std::string>{"oriented.film.event.0.kind: \"weld\" -> \"crease\"",
                                      "oriented.film.growth: \"none\" -> \"borders\"",
                                      "surface.merge: \"liquid\" -> \"none\"",
                                      "surface.smoothing: \"sphere\" -> \"plane\""}));
  other = s;
  other.oriented[0].integrator = OrientedIntegrator::RungeKutta;
  other.oriented[0].facing = false;
  other.oriented[0].fields.clear();
  other.sheets[0].selfContact = true;
  other.materials[0].law.name = "neo-hookean";
  std::vector<std::string> reported = coefficientChanges(then, other);
  std::erase_if(reported, [](const std::string& t) {
    return t.find("field.0") != std::string::npos && t.find("field.0.until") == std::string::npos;
  });
  EXPECT_EQ(reported, (std::vector<std::string>{"material.wax.law: \"green\" -> \"neo-hookean\"",
                                                "oriented.film.facing: true -> false",
                                                "oriented.film.field.0.until: \"never\" -> not in the scene",
                                                "oriented.film.integrator: \"symplectic\" -> \"rk4\"",
                                                "sheet.cloth.self_contact: false -> true"}));
  other = s;
  other.surface.source = SurfelSource::Particles;
  other.bodies[0].packing = Packing::Relaxed;
  other.bodies[0].material = 1;
  other.bodies[0].shape.kind = ShapeKind::Torus;
  EXPECT_EQ(initialStateChanges(then, other),
            std::vector<std::string>{"surface.source: \"automatic\" -> \"particles\""});
  EXPECT_EQ(
      restartConflicts(then, other),
      (std::vector<std::string>{
          "body.bust.box.size is not in the scene any more", "body.bust.material: \"wax\" -> \"oil\"",
          "body.bust.packing: \"lattice\" -> \"relaxed\"", "body.bust.torus.radius was not in the scene then",
          "body.bust.torus.tube was not in the scene then"}));
}

TEST(RestartRecord, MessageNamesTheKeyAndBothValues) {
  Scene s = sample();
  const CheckpointValues then = restartRecordOf(s);
  s.spacing = 0.02;
  ASSERT_EQ(restartConflicts(then, s).size(), 1u);
  EXPECT_EQ(restartConflicts(then, s)[0], "spacing: 0.01 -> 0.02 m");
}

TEST(RestartRecord, FractionsAreRoundedUnlessTheyThenAgree) {
  Scene s = sample();
  s.spacing = 0.1 + 0.2;  // 0.30000000000000004
  CheckpointValues then = restartRecordOf(s);
  s.spacing = 0.25;
  EXPECT_EQ(restartConflicts(then, s), std::vector<std::string>{"spacing: 0.3 -> 0.25 m"});
  s.spacing = 0.3;
  EXPECT_EQ(restartConflicts(then, s), std::vector<std::string>{"spacing: 0.30000000000000004 -> 0.3 m"});
}

TEST(RestartRecord, HalfSpacesAreComparedByPointAndNormal) {
  Scene s = sample();
  s.sheets.emplace_back().name = "cloth";
  s.sheets[0].regions.emplace_back().shape.kind = ShapeKind::HalfSpace;
  s.bodies[0].shape.kind = ShapeKind::Difference;
  s.bodies[0].shape.parts.resize(2);
  s.bodies[0].shape.parts[1].kind = ShapeKind::HalfSpace;
  const CheckpointValues then = restartRecordOf(s);
  Scene other = s;
  other.sheets[0].regions[0].shape.point.x = 0.1;
  EXPECT_EQ(restartConflicts(then, other).size(), 1u);
  other = s;
  other.bodies[0].shape.parts[1].normal = {1, 0, 0};
  EXPECT_EQ(restartConflicts(then, other).size(), 1u);
}

TEST(RestartRecord, MeshesAreComparedByContent) {
  TriangleMesh cloth{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, moved = cloth, turned = cloth;
  moved.vertices[2].y = 1.1;
  turned.triangles[0] = {0, 2, 1};
  const auto sceneOf = [](const std::string& path, const TriangleMesh& mesh) {
    Scene s = sample();
    s.sheets.emplace_back().name = "cloth";
    s.sheets[0].mesh = SheetMesh::File;
    s.sheets[0].shape.kind = ShapeKind::Mesh;
    s.sheets[0].shape.mesh = path;
    fingerprintMeshes(s, [&](const std::string&) { return mesh; });
    return s;
  };
  const CheckpointValues then = restartRecordOf(sceneOf("/a/cloth.obj", cloth));
  EXPECT_TRUE(restartConflicts(then, sceneOf("/b/cloth.obj", cloth)).empty());
  EXPECT_EQ(restartConflicts(then, sceneOf("/a/cloth.obj", moved)).size(), 1u);
  EXPECT_EQ(restartConflicts(then, sceneOf("/a/cloth.obj", turned)).size(), 1u);
}

TEST(RestartRecord, ExternalActionsAreReported) {
  Scene s = sample();
  s.sheets.emplace_back().name = "cloth";
  s.sheets[0].pressureBrushes.emplace_back();
  s.oriented.emplace_back().name = "film";
  s.oriented[0].fields.emplace_back().everywhere = false;
  s.oriented[0].fields[0].region.kind = ShapeKind::Sphere;
  s.obstacles.emplace_back().name = "pan";
  const CheckpointValues then = restartRecordOf(s);
  const auto reported = [&](auto&& change) {
    Scene other = s;
    change(other);
    EXPECT_TRUE(restartConflicts(then, other).empty());
    return coefficientChanges(then, other).size() + settingChanges(then, other, 0).size();
  };
  EXPECT_EQ(reported([](Scene&) {}), 0u);
  EXPECT_EQ(reported([](Scene& o) { o.sheets[0].shrinkWrapTo = "pan"; }), 1u);
  EXPECT_EQ(reported([](Scene& o) {
              o.sheets[0].pressureBrushes[0].motion.push_back({1, {1, 0, 0}, {}});
            }),
            2u);
  EXPECT_EQ(reported([](Scene& o) { o.oriented[0].cfl = 1; }), 1u);
  EXPECT_EQ(reported([](Scene& o) { o.oriented[0].fields[0].radius = 7; }), 1u);  // its region has a radius
                                                                                  // as well
  EXPECT_EQ(reported([](Scene& o) { o.oriented[0].fields[0].region.radius = 7; }), 1u);
  EXPECT_EQ(reported([](Scene& o) { o.obstacles[0].shape.move.z = 1; }), 1u);
  EXPECT_EQ(reported([](Scene& o) { o.obstacles[0].temperature = 500; }), 1u);
  EXPECT_EQ(reported([](Scene& o) { o.domain.side[2] = {Side::Wall, Side::Open}; }), 1u);
  EXPECT_EQ(reported([](Scene& o) { o.numerics.kernel = KernelKind::Mcg03; }), 1u);
  EXPECT_EQ(reported([](Scene& o) { o.materials[0].emissivity = 1; }), 1u);
}

TEST(RestartRecord, PastEventsAreReportedAsWithoutEffect) {
  Scene s = sample();
  s.oriented.emplace_back().name = "film";
  const CheckpointValues then = restartRecordOf(s);
  s.oriented[0].events.emplace_back().time = 1;
  EXPECT_TRUE(pastEventChanges(then, s, 0.9).empty());
  EXPECT_FALSE(settingChanges(then, s, 0.9).empty());
  EXPECT_FALSE(pastEventChanges(then, s, 1).empty());
  EXPECT_TRUE(settingChanges(then, s, 1).empty());
  Scene later = s;
  later.oriented[0].events[0].time = 2;  // it has happened and will happen again
  EXPECT_FALSE(settingChanges(restartRecordOf(s), later, 1.5).empty());
  EXPECT_FALSE(settingChanges(restartRecordOf(later), s, 1.5).empty());  // it was to happen and will not
}

TEST(RestartRecord, ChangesAmongManyBodiesAreFound) {
  Scene s = sample();
  for (int k = 0; k < 150; k++) s.bodies.emplace_back().name = "ball " + std::to_string(k);
  const CheckpointValues then = restartRecordOf(s);
  Scene other = s;
  other.bodies.back().shape.move.x = 1;
  EXPECT_EQ(restartConflicts(then, other).size(), 1u);
  other = s;
  other.bodies.back().velocity.x = 1;
  EXPECT_EQ(initialStateChanges(then, other).size(), 1u);
}

TEST(RestartRecord, CheckpointWithoutRecordIsRefused) {
  EXPECT_FALSE(restartConflicts({}, sample()).empty());
}

}  // namespace
}  // namespace thaw
