// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/modules/step_modules.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <set>
#include <span>
#include <vector>

namespace thaw {
namespace {

std::size_t callsOf(const StepPhases& phases) {
  std::size_t n = 0;
  for (const auto& calls : phases.calls) n += calls.size();
  return n;
}

/// Calls of the named modules in a phase, in the order of the names.
std::vector<PhaseCall> callsOf(const std::vector<std::string_view>& names, ModulePhase phase) {
  std::vector<PhaseCall> calls;
  for (const std::string_view name : names)
    for (const StepModule& module : stepModules())
      for (const ModuleCall& c : module.calls)
        if (module.name == name && c.phase == phase) calls.push_back(c.call);
  return calls;
}

}  // namespace

TEST(StepModules, HaveUniqueNamesAndAtMostOneCallPerPhase) {
  std::set<std::string_view> names;
  for (const StepModule& module : stepModules()) {
    EXPECT_TRUE(names.insert(module.name).second) << module.name;
    EXPECT_FALSE(module.calls.empty()) << module.name;
    std::set<ModulePhase> phases;
    for (const ModuleCall& c : module.calls) EXPECT_TRUE(phases.insert(c.phase).second) << module.name;
  }
}

TEST(StepModules, ReadOnlyColumnsThatGhostsHave) {
  Continuum p;
  for (const StepModule& module : stepModules()) {
    const GhostColumns ghosts = module.ghosts(p);
    for (const ColumnList& list : {ghosts.withPositions, ghosts.withDensities})
      for (const AnyColumn* column : std::span<AnyColumn* const>(list))
        EXPECT_EQ(column->rows, Rows::All) << module.name << ", " << column->name;
  }
}

TEST(StepModules, SendTheActiveColumnsOfTheSceneOnce) {
  World w;
  Continuum& p = w.particles;
  w.modules.continuity = w.modules.incompressible = w.modules.sleep = true;
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{&p.position, &p.velocity, &p.mass, &p.material,
                                                        &p.phase, &p.clamped, &p.sleep, &p.piece})
    p.activate(*c);
  const StepPhases phases = phasesOf(w, TermWork{});
  const std::span<AnyColumn* const> sent = phases.ghosts.withPositions;
  // `clamped` belongs to two modules, `restTime` is not active, and nothing here reads `piece`.
  const std::vector<AnyColumn*> expected{&p.position, &p.velocity, &p.mass,   &p.material,
                                         &p.phase,    &p.sleep,    &p.clamped};
  EXPECT_EQ(std::set<AnyColumn*>(sent.begin(), sent.end()),
            std::set<AnyColumn*>(expected.begin(), expected.end()));
  EXPECT_EQ(sent.size(), expected.size());
}

TEST(StepModules, SceneWithoutModulesHasOnlyLoadsFromOutside) {
  World w;
  EXPECT_EQ(callsOf(phasesOf(w, TermWork{})), 3u);
}

TEST(StepModules, ActInTheOrderOfTheirList) {
  World w;
  w.modules.buoyancy = w.modules.sleep = w.modules.heat = true;
  const StepPhases phases = phasesOf(w, TermWork{});
  const auto in = [&](ModulePhase phase) { return phases.calls[static_cast<std::size_t>(phase)]; };
  EXPECT_EQ(in(ModulePhase::SecondKick),
            callsOf({"loads from outside", "sleep", "buoyancy"}, ModulePhase::SecondKick));
  EXPECT_EQ(in(ModulePhase::AllForces), callsOf({"loads from outside", "heat"}, ModulePhase::AllForces));
  EXPECT_TRUE(in(ModulePhase::EndOfStep).empty());
}

}  // namespace thaw
