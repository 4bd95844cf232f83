// SPDX-License-Identifier: Apache-2.0
// A simulation on one rank: the world, and the data to start and step it. Shared by runs, benchmarks, tests.
#pragma once
#include <tuple>

#include "core/simulation/setup/setup.hpp"
#include "core/simulation/world/world_halos.hpp"

namespace thaw {

/// AllRanks, Cells and Bonds implement Reducer, CellHalo and BondHalo. Ranks are the first arguments of their
/// constructors: a communicator, which must outlive the simulation, or nothing.
template<class AllRanks, class Cells, class Bonds, class... Ranks> struct RankSimulation {
  World world;
  StepTools tools;
  AllRanks all;
  WorldHalos<Cells, Bonds> tables;
  std::tuple<const Ranks&...> ranks;

  explicit RankSimulation(const Ranks&... r) : all(r...), ranks(r...) {}
  Halos halos() { return tables.with(all); }

  /// Makes new halos for a prepared world without particles. Collective.
  void makeHalos() {
    std::apply([&](const Ranks&... r) { tables.make(world, r...); }, ranks);
  }
  /// Prepares the world and its halos, without particles: the common part of a fresh run and a restart.
  /// Requires: world.scene is set. Throws as prepareWorld. Collective.
  void prepare(const MeshLoader& load) {
    prepareWorld(world, tools, load);
    makeHalos();
  }
  /// Samples the bodies and computes the first forces. `change` acts on the particles before bonds form.
  /// Requires: prepare. Throws as sampleWorld. Collective.
  SamplingReport start(const MeshLoader& load, const ParticleChange& change = {}) {
    return startWorld(world, halos(), tools, load, change);
  }
  /// Takes one step. Collective.
  StepOutcome step(const Requests& requests = {}) { return thaw::step(world, halos(), tools, requests); }
};

}  // namespace thaw
