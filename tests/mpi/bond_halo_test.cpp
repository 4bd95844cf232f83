// SPDX-License-Identifier: Apache-2.0
// The distributed bond graph against a complete model on every rank: random graphs, owners, melting,
// freezing, breaking.
#include <gtest/gtest.h>

#include "tests/support/bond_halo_rig.hpp"

namespace thaw {
namespace {

using namespace test;

void play(std::size_t particles, std::uint64_t seed, int rounds, double oneEnded,
          std::size_t chunk = largestChunk) {
  Rig rig(particles, seed, chunk);
  Dice& d = rig.dice;
  for (int round = 0; round < rounds; round++) {
    SCOPED_TRACE("round " + std::to_string(round));
    const double much = d.chance(0.2) ? 0.6 : 0.03;
    if (round == 0 || d.chance(0.8)) {
      rig.meltAndFreeze(round == 0 ? 0 : much * 0.5, round == 0 ? 0.8 : much);
      rig.rebuildBonds();
      if (!rig.good("melt and freeze")) return;
    }
    if (round == 0 || d.chance(0.7)) {
      rig.rebuildBonds(rig.requests(round == 0 ? 3 * particles : d.below(particles / 4 + 4), oneEnded));
      if (!rig.good("requests")) return;
    }
    if (d.chance(0.3)) {
      rig.breakSome(0.05);
      if (d.chance(0.5)) {
        rig.rebuildBonds();
        if (!rig.good("break")) return;
      }
    }
    const int target = d.chance(0.15) ? static_cast<int>(d.below(static_cast<std::size_t>(rig.comm.size())))
                                      : -1;
    const bool everything = d.chance(0.1), withChange = d.chance(0.3);
    if (d.chance(0.3)) rig.meltAndFreeze(0.05, 0.05);  // as at the end of a step
    rig.migrate(everything ? 1 : much, target, d.chance(0.3) ? 0.02 : 0);
    if (withChange) rig.meltAndFreeze(0.05, 0.05);
    rig.rebuildBonds();
    if (!rig.good("migrate")) return;
    EXPECT_FALSE(rig.rebuildBonds());  // nothing changed
  }
}

TEST(BondHalo, MatchesTheModelForManyParticles) { play(400, 1, 40, 0); }
TEST(BondHalo, MatchesTheModelForOneEndedBonds) { play(150, 2, 60, 0.3); }
TEST(BondHalo, SplitsMessagesIntoChunks) {
  play(200, 4, 15, 0.1, smallestChunk);
  play(200, 5, 15, 0.1, 1000);
}
TEST(BondHalo, MatchesTheModelForFewParticles) {
  for (std::uint64_t seed = 10; seed < 20; seed++) play(5, seed, 30, 0.1);
}
TEST(BondHalo, MatchesTheModelForManyGraphs) {
  for (std::uint64_t seed = 100; seed < 160; seed++) play(seed % 50, seed, 10, seed % 3 == 0 ? 0.2 : 0);
}
TEST(BondHalo, MatchesTheModelForOneParticle) { play(1, 5, 30, 0); }
TEST(BondHalo, HandlesNoParticles) { play(0, 6, 3, 0); }

TEST(BondHalo, SecondMigrationNeedsARebuild) {
  Rig rig(20, 7);
  rig.meltAndFreeze(0, 1);
  rig.rebuildBonds();
  rig.migrate(1, 0, 0);
  if (rig.comm.size() == 1) return;  // no rank to migrate to
  EXPECT_THROW(rig.halo->migrate(rig.p, rig.s, rig.b, {}), std::logic_error);
}

/// Records written on some ranks and read on others build the same graph, whether particles are redistributed
/// before or after the first rebuild of bonds.
TEST(BondHalo, BuildsTheSameGraphFromRecords) {
  for (const bool rebuildFirst : {false, true}) {
    Rig rig(120, 8);
    rig.meltAndFreeze(0, 0.9);
    rig.rebuildBonds();
    rig.rebuildBonds(rig.requests(500, 0));
    if (!rig.good("before")) return;
    SolidRecords records;
    for (std::uint32_t solidIndex = 0; solidIndex < rig.s.owned; solidIndex++)
      appendRecord(rig.s, rig.b, solidIndex, records);
    rig.halo = std::make_unique<MpiBondHalo>(rig.comm);
    rig.s.resize(rig.s.owned, 0);
    rig.s.resize(0, 0);
    rig.digest.clear();
    rig.b = Bonds{};
    rig.b.twoFrames = true;
    std::fill_n(rig.p.solidIndex.data(), rig.p.owned, noSolid);
    rig.halo->adopt(std::move(records.bytes));
    if (rebuildFirst) {
      rig.rebuildBonds();
      if (!rig.good("adopted")) return;
    }
    for (const double chance : {1.0, 0.3}) {
      rig.migrate(chance, -1, 0);
      rig.rebuildBonds();
      if (!rig.good("moved")) return;
    }
  }
}

}  // namespace
}  // namespace thaw
