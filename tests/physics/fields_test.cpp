// SPDX-License-Identifier: Apache-2.0
// A scene allocates only the fields that it needs. A new field belongs in the lists of the scenes that need
// it, and in no other.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/simulation/memory.hpp"
#include "core/simulation/time/integrate.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

using Names = std::vector<std::string>;

Scene block(bool solid) {
  Scene s = columnScene(0.1, -1, 1);
  s.domain.side = {};
  s.domain.min = {-1, -1, -1};
  s.domain.max = {1, 1, 1};
  s.materials[0].soundSpeed = 10;
  if (solid) s.materials[0].young = {1e5, 0};
  addBox(s, {-0.3, -0.3, -0.3}, {0.3, 0.3, 0.3});
  return s;
}

Names fields(const Scene& s) { return fieldsOf(Simulation(s).w); }

/// Fields of `with` that `without` lacks. Fails if `with` lacks a field of `without`, except for the common
/// reference configuration of solids whose bonds have their own references.
Names added(const Scene& with, const Scene& without) {
  const Names all = fields(with);
  Names more;
  for (const std::string& n : fields(without))
    EXPECT_TRUE(n == "solid.reference" || std::find(all.begin(), all.end(), n) != all.end()) << n;
  const Names base = fields(without);
  for (const std::string& n : all)
    if (std::find(base.begin(), base.end(), n) == base.end()) more.push_back(n);
  return more;
}

const Names always{"continuum.id",   "continuum.position", "continuum.velocity",    "continuum.acceleration",
                   "continuum.mass", "continuum.material", "continuum.body",        "continuum.dissipated",
                   "continuum.cell", "continuum.phase",    "continuum.dissipation", "continuum.interaction"};

Names with(Names base, const Names& more) {
  base.insert(base.end(), more.begin(), more.end());
  std::sort(base.begin(), base.end());
  return base;
}
Names sorted(Names n) { return std::sort(n.begin(), n.end()), n; }

}  // namespace

TEST(Fields, LiquidHasTheNecessaryOnes) {
  EXPECT_EQ(sorted(fields(block(false))), with(always, {"continuum.relativeDensity"}));
}

TEST(Fields, SolidHasTheNecessaryOnes) {
  EXPECT_EQ(
      sorted(fields(block(true))),
      with(always, {"continuum.solid_index", "solid.id", "solid.particle", "solid.material",
                    "solid.reference", "solid.volume", "solid.position", "solid.momentInverse",
                    "solid.deformation", "solid.endDouble", "solid.force", "solid.energy", "solid.changed"}));
}

// Forces share storage with accelerations, unless both are read or a constrained particle's acceleration
// differs from its force.
TEST(Fields, ForcesAreSeparateWhereNecessary) {
  Scene clamped = block(true);
  clamped.domain.gravity = {0, 0, -9.81};
  Scene free = clamped;
  clamped.bodies[0].clamp.emplace_back();
  clamped.bodies[0].clamp[0].size = {2, 2, 0.2};
  clamped.bodies[0].clamp[0].move = {0, 0, -0.3};
  EXPECT_EQ(added(clamped, block(true)), (Names{"continuum.clamped", "continuum.force"}));
  for (const bool own : {false, true}) {
    Simulation run(own ? clamped : free);
    Continuum& p = run.particles();
    EXPECT_EQ(p.force.shares(), !own);
    for (int k = 0; k < 20; k++) ASSERT_TRUE(run.step());
    double largest = 0;
    for (std::size_t i = 0; i < p.owned; i++) {
      largest = std::max(largest, length(forceOf(run.w.particles, run.w.scene, i)));
      if (own && p.clamped[i]) continue;
      EXPECT_LT(length(forceOf(run.w.particles, run.w.scene, i) / p.mass[i] + free.domain.gravity -
                       p.acceleration[i]),
                1e-10 * length(free.domain.gravity))
          << i;
    }
    EXPECT_EQ(largest > 1e-3 * p.mass[0], own) << "free fall has no force";
  }
}

TEST(Fields, HeatAddsItsOwn) {
  Scene s = block(false);
  s.materials[0].conductivity = {1, 1};
  s.bodies[0].temperatureGradient = {1, 0, 0};
  EXPECT_EQ(added(s, block(false)),
            (Names{"continuum.enthalpy", "continuum.temperature", "continuum.heatFlow"}));
  Scene lossy = s;
  lossy.materials[0].convection = 1;
  EXPECT_EQ(added(lossy, s), (Names{"continuum.conductionCorrection", "continuum.exposedArea"}));
}

TEST(Fields, CohesionAndArtificialViscosityAddNone) {
  Scene s = block(false);
  s.materials[0].surfaceTension = 0.05;
  s.materials[0].artificialViscosity = 0.1;
  s.numerics.tension = TensionForm::Pairwise;
  EXPECT_EQ(added(s, block(false)), Names{});
  Scene energy = s;
  energy.numerics.tension = TensionForm::SurfaceEnergy;
  EXPECT_EQ(added(energy, s),
            (Names{"continuum.surfaceGradient", "continuum.surfaceColour",
                   "continuum.surfaceEnergyByGradient", "continuum.surfaceEnergyByColour"}));
  s.materials[0].xsph = 0.1;
  EXPECT_EQ(added(s, block(false)), (Names{"continuum.shiftingVelocity"}));
}

TEST(Fields, YieldFractureAndDampingAddTheirOwn) {
  Scene plastic = block(true);
  plastic.materials[0].yieldStrain = {0.1, 0.1};
  plastic.materials[0].maxPlasticStrain = 0.1;
  EXPECT_EQ(added(plastic, block(true)),
            (Names{"solid.plasticInverse", "solid.lastGradient", "solid.dissipated"}));
  plastic.materials[0].maxPlasticStrain = never;
  EXPECT_EQ(added(plastic, block(true)), (Names{"solid.plasticInverse", "solid.referenceGradient",
                                                "solid.velocity", "solid.dissipated", "solid.rereferenced"}));
  Scene hard = plastic;
  hard.materials[0].hardening = 1e5;
  EXPECT_EQ(added(hard, plastic), (Names{"solid.plasticPath"}));
  Scene breaks = block(true);
  breaks.materials[0].breakStretch = 1.5;
  EXPECT_EQ(added(breaks, block(true)), (Names{"solid.velocity"}))
      << "the energy of a break needs the ends' positions at the drift";
  Scene damped = block(true);
  damped.materials[0].damping = 1;
  EXPECT_EQ(added(damped, block(true)), (Names{"solid.velocity", "solid.drag", "solid.dissipated"}));
}

TEST(Fields, MeltingAddsItsOwn) {
  Scene s = block(true);
  Material& m = s.materials[0];
  m.solidus = m.liquidus = 350;
  EXPECT_EQ(added(s, block(true)), Names{}) << "without heat nothing melts";
  m.conductivity = {1, 1};
  s.bodies[0].temperatureGradient = {1, 0, 0};
  EXPECT_EQ(
      added(s, block(true)),
      (Names{"continuum.relativeDensity", "continuum.enthalpy", "continuum.temperature", "continuum.heatFlow",
             "continuum.conductionCorrection", "continuum.liquid", "continuum.softening", "continuum.frame",
             "continuum.justFrozen", "continuum.contactOffset", "solid.liquid", "solid.melted"}));
}

TEST(Fields, SurfaceAddsTwoToParticlesAndItsOwnTables) {
  Scene s = block(false);
  s.surface.on = true;
  const auto ofParticles = [&] {
    Names names;
    for (const std::string& n : added(s, block(false)))
      if (n.compare(0, 8, "surfels.") != 0 && n.compare(0, 18, "surface particles.") != 0) names.push_back(n);
    return names;
  };
  s.surface.enforceVolume = 0;
  EXPECT_EQ(ofParticles(),
            (Names{"continuum.surfacePosition", "continuum.component", "continuum.initialFill"}));
  s.surface.enforceVolume = 1;
  EXPECT_EQ(ofParticles(), (Names{"continuum.surfacePosition", "continuum.component",
                                  "continuum.surfaceVolumeRatio", "continuum.initialFill"}));
  s.bodies[0].packing = Packing::Relaxed;
  EXPECT_EQ(ofParticles(),
            (Names{"continuum.surfacePosition", "continuum.component", "continuum.surfaceVolumeRatio"}))
      << "a relaxed packing has no staircase to smooth";
}

TEST(Fields, AbsentOnesUseNoMemory) {
  const Simulation liquid(block(false));
  const Names absent{"solids", "bonds", "elastic work", "surface"};
  for (const MemoryUse& u : memoryOf(liquid.w, liquid.tools)) {
    if (std::find(absent.begin(), absent.end(), u.what) == absent.end()) continue;
    EXPECT_EQ(u.bytes, 0) << u.what;
  }
}

}  // namespace thaw::test
