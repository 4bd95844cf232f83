// SPDX-License-Identifier: Apache-2.0
// `quality` selects the defaults of [numerics]; explicit keys take precedence. Liquid that fills a periodic
// box has its own defaults.
#include <gtest/gtest.h>

#include "io/scene/read_scene.hpp"

namespace thaw {
namespace {

Scene sceneOf(const std::string& head, const std::string& numerics = "", const std::string& sides = "",
              const std::string& body = "", const std::string& material = "") {
  SceneFiles files;
  files.main = "test.toml";
  files.texts["test.toml"] = head + "\nspacing = 0.1\nend = 1\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n" +
                             sides + "[numerics]\n" + numerics + "\n[material.oil]\ndensity = 1000\n" +
                             material +
                             "\n[[body]]\nname = 'all'\nmaterial = 'oil'\n"
                             "box = { size = [1, 1, 1] }\nplace = { move = [0.5, 0.5, 0.5] }\n" +
                             body;
  return readScene(files);
}

constexpr const char* periodic = "sides = { x = 'periodic', y = 'periodic', z = 'periodic' }\n";

}  // namespace

TEST(Quality, PicksDefaults) {
  const Numerics standard;
  EXPECT_EQ(sceneOf("").numerics.cflElastic, standard.cflElastic);
  EXPECT_EQ(sceneOf("quality = 'standard'").numerics.precision, standard.precision);
  EXPECT_EQ(sceneOf("quality = 'preview'").numerics.elasticPrecision, Precision::Single);
  EXPECT_GT(sceneOf("quality = 'preview'").numerics.maxDensityError, standard.maxDensityError);
  EXPECT_EQ(sceneOf("quality = 'reference'").numerics.precision, Precision::Double);
  EXPECT_EQ(sceneOf("quality = 'reference'").numerics.density, DensityForm::Continuity);
  EXPECT_LT(sceneOf("quality = 'reference'").numerics.cflSound, standard.cflSound);
  EXPECT_GT(sceneOf("quality = 'reference'").materials[0].hourglass, Material().hourglass);
}

TEST(Quality, ExplicitKeysTakePrecedence) {
  const Scene s = sceneOf("quality = 'reference'", "precision = 'single'\ncfl_sound = 0.3");
  EXPECT_EQ(s.numerics.precision, Precision::Single);
  EXPECT_EQ(s.numerics.cflSound, 0.3);
  EXPECT_EQ(s.numerics.density, sceneOf("quality = 'reference'").numerics.density);
}

TEST(Quality, ReferenceWithTheIncompressibleSolver) {
  EXPECT_EQ(sceneOf("quality = 'reference'", "pressure_solver = 'incompressible'").numerics.density,
            DensityForm::Summation);
  EXPECT_EQ(sceneOf("quality = 'reference'", "pressure_solver = 'incompressible'\ndensity = 'plain'")
                .numerics.density,
            DensityForm::Plain);
}

TEST(Quality, ReferenceCarriesTheDensityOfEmittedLiquid) {
  const std::string spout = "[[emitter]]\ndisc = { radius = 0.02 }\nmaterial = 'oil'\n";
  const auto densityOf = [&](const std::string& numerics) {
    return readScene(sceneFilesOf("poured.toml",
                                  "spacing = 0.01\nquality = 'reference'\n[domain]\nmin = [-1, -1, -1]\nmax "
                                  "= [1, 1, 1]\n[material.oil]\n[numerics]\n" +
                                      numerics + "\n" + spout))
        .numerics.density;
  };
  EXPECT_EQ(densityOf(""), DensityForm::Continuity);
  EXPECT_EQ(densityOf("density = 'summation'"), DensityForm::Summation);
}

TEST(Quality, UnknownWordIsAnError) { EXPECT_THROW(sceneOf("quality = 'best'"), SceneErrors); }

TEST(FullBox, HasItsOwnDefaults) {
  const Numerics full = sceneOf("", "", periodic).numerics, open = sceneOf("").numerics;
  for (const Numerics& n : {full, open}) {
    EXPECT_EQ(n.density, DensityForm::Continuity);
    EXPECT_EQ(n.tensileLimit, 1);
    EXPECT_GT(n.shifting, 0);
  }
  EXPECT_EQ(sceneOf("", "", periodic).bodies[0].packing, Packing::Relaxed);
  EXPECT_EQ(sceneOf("").bodies[0].packing, Packing::Lattice);
}

// Negative pressure would resist the small changes of density with which disordered layers slide.
TEST(FullBox, HasNoNegativePressureWithTheIncompressibleSolver) {
  const std::string solver = "pressure_solver = 'incompressible'";
  EXPECT_EQ(sceneOf("", solver, periodic).numerics.tensileLimit, 0);
  const Numerics n = sceneOf("", solver, periodic, "", "expansion = 1e-3").numerics;
  EXPECT_EQ(n.buoyancy, Buoyancy::Boussinesq);
  EXPECT_EQ(n.tensileLimit, 0);
}

TEST(FullBox, KeepsExplicitChoices) {
  const Numerics n = sceneOf("", "density = 'summation'\ntensile_limit = 0.5", periodic).numerics;
  EXPECT_EQ(n.density, DensityForm::Summation);
  EXPECT_EQ(n.tensileLimit, 0.5);
  EXPECT_EQ(n.shifting, 0);
  EXPECT_EQ(sceneOf("", "density = 'summation'", periodic).bodies[0].packing, Packing::Lattice);
  EXPECT_EQ(sceneOf("", "shifting = 0.1", periodic, "packing = 'lattice'").bodies[0].packing,
            Packing::Lattice);
}

TEST(FullBox, StaysOnTheLatticeWhereTheTemperatureVaries) {
  EXPECT_EQ(sceneOf("", "", periodic, "temperature_gradient = [1, 0, 0]").bodies[0].packing,
            Packing::Lattice);
}

TEST(Liquid, UsesContinuityAndNegativePressureByDefault) {
  for (const std::string domain : {"gravity = [0, 0, 0]\n", "sides = { z = ['wall', 'open'] }\n"}) {
    const Numerics n = sceneOf("", "", domain).numerics;
    EXPECT_EQ(n.density, DensityForm::Continuity);
    EXPECT_EQ(n.tensileLimit, 1);
    EXPECT_GT(n.shifting, 0);
    EXPECT_EQ(sceneOf("quality = 'preview'", "", domain).numerics.density, DensityForm::Summation);
    EXPECT_EQ(sceneOf("", "density = 'summation'", domain).numerics.tensileLimit, 0);
    EXPECT_EQ(sceneOf("", "shifting = 0", domain).numerics.tensileLimit, 0);
  }
}

TEST(Liquid, SurfaceTensionActsByCurvatureWhereTheSceneAllowsIt) {
  const auto numericsOf = [](const std::string& numerics, const std::string& top = "") {
    return readScene(sceneFilesOf("drop.toml",
                                  top + "spacing = 0.01\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n" +
                                      "[numerics]\n" + numerics +
                                      "\n[material.water]\nsurface_tension = 0.07\n"
                                      "[[body]]\nmaterial = 'water'\nsphere = { radius = 0.1 }\n"))
        .numerics;
  };
  EXPECT_EQ(numericsOf("").tension, TensionForm::Curvature);
  EXPECT_EQ(numericsOf("").density, DensityForm::Continuity);
  EXPECT_EQ(numericsOf("").tensileLimit, 1);
  for (const char* other : {"density = 'summation'", "shifting = 0", "support = 1.5",
                            "pressure_solver = 'incompressible'", "tension = 'surface energy'"}) {
    EXPECT_EQ(numericsOf(other).tension, TensionForm::SurfaceEnergy) << other;
    EXPECT_EQ(numericsOf(other).density, DensityForm::Summation) << other;
  }
  EXPECT_EQ(numericsOf("", "quality = 'preview'\n").tension, TensionForm::SurfaceEnergy);
  EXPECT_EQ(numericsOf("tension = 'pairwise'").density, DensityForm::Summation);
}

TEST(Liquid, NegativePressureRequiresShiftingAndContinuity) {
  EXPECT_THROW(sceneOf("", "tensile_limit = 1\ndensity = 'summation'"), SceneErrors);
  EXPECT_THROW(sceneOf("", "tensile_limit = 1\nshifting = 0.2\ndensity = 'summation'"), SceneErrors);
  EXPECT_THROW(sceneOf("", "tensile_limit = 1\nshifting = 0"), SceneErrors);
  EXPECT_NO_THROW(sceneOf("", "tensile_limit = 1\ndensity = 'continuity'\nshifting = 0.2"));
}

}  // namespace thaw
