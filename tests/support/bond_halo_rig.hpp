// SPDX-License-Identifier: Apache-2.0
// The distributed bond graph and a complete model of it on every rank.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>

#include "parallel/bond_halo.hpp"

namespace thaw::test {

struct ModelBond {
  std::uint64_t to;
  double weight;
};
struct ModelParticle {
  int owner = 0;
  bool gone = false, solid = false, markExposed = false;
  std::vector<ModelBond> bonds;
};

/// Random numbers that are the same on every rank.
struct Dice {
  std::uint64_t state;
  std::uint64_t next() { return state = spreadBits(state + 0x9e3779b97f4a7c15ull); }
  std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(next() % n); }
  bool chance(double p) { return static_cast<double>(next() >> 11) * 0x1p-53 < p; }
};

inline double number(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  return static_cast<double>(spreadBits(spreadBits(a * 31 + b) + c) >> 12);
}
inline BondRecord randomBond(std::uint64_t from, std::uint64_t to, double weight) {
  BondRecord r{to, {}, {}, weight};
  for (std::uint64_t a = 0; a < 3; a++)
    r.reference[a] = number(from, to, a), r.reverse[a] = number(to, from, a + 3);
  return r;
}

struct Rig {
  Communicator comm;
  std::unique_ptr<MpiBondHalo> halo = std::make_unique<MpiBondHalo>(comm);
  Continuum p;
  Solids s;
  Bonds b;
  std::vector<ModelParticle> model;
  Dice dice;
  std::vector<std::uint64_t> digest;  // checksum of each solid's bonds, updated where Solids::changed is set
  bool changedHere = false;
  std::set<std::size_t> turnedBefore;

  Rig(std::size_t particles, std::uint64_t seed, std::size_t chunk = largestChunk)
      : comm(MPI_COMM_WORLD, chunk), dice{seed} {
    for (AnyColumn* c : std::initializer_list<AnyColumn*>{&p.id, &p.phase, &p.material, &p.solidIndex})
      p.activate(*c);
    for (AnyColumn* c :
         std::initializer_list<AnyColumn*>{&s.id, &s.particle, &s.material, &s.volume, &s.plasticInverse,
                                           &s.position, &s.liquid, &s.exposed, &s.changed})
      s.activate(*c);
    b.twoFrames = true;
    model.resize(particles);
    for (ModelParticle& m : model)
      m.owner = static_cast<int>(dice.below(static_cast<std::size_t>(comm.size())));
    for (std::size_t i = 0; i < model.size(); i++)
      if (model[i].owner == comm.rank()) addParticle(i);
    sort({});
  }
  static std::uint64_t idOf(std::size_t i) { return std::uint64_t(i % 3) << 40 | i * 7; }
  static std::size_t indexOf(std::uint64_t id) { return (id & ((1ull << 40) - 1)) / 7; }

  void addParticle(std::size_t i) {
    p.resize(p.owned + 1, 0);
    p.id[p.owned - 1] = idOf(i);
    p.phase[p.owned - 1] = model[i].solid ? Solid : Liquid;
    p.material[p.owned - 1] = static_cast<std::uint16_t>(i % 5);
    p.solidIndex[p.owned - 1] = model[i].solid ? 12345 : noSolid;  // invalid until the halo sets it
  }
  /// Sorts particles in an order unrelated to solid indices, without the rows `without`.
  void sort(const std::vector<std::uint32_t>& without) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < p.owned; i++)
      if (!std::binary_search(without.begin(), without.end(), i)) order.push_back(i);
    std::sort(order.begin(), order.end(),
              [&](auto i, auto j) { return spreadBits(p.id[i]) < spreadBits(p.id[j]); });
    p.reorder(order);
    linkSolids(p, s);
  }

  /// Gives every particle a new owner with probability `chance` (the target, or any if it is negative), or
  /// removes it from the domain.
  void migrate(double chance, int target, double leaving) {
    Migration m;
    std::vector<int> before;
    for (std::size_t i = 0; i < model.size(); i++) {
      before.push_back(model[i].owner);
      if (model[i].gone) continue;
      if (dice.chance(leaving)) {
        model[i].gone = true;
        remove(i);
      } else if (dice.chance(chance)) {
        model[i].owner = target >= 0 ? target
                                     : static_cast<int>(dice.below(static_cast<std::size_t>(comm.size())));
      }
    }
    for (std::uint32_t i = 0; i < p.owned; i++) {
      const ModelParticle& x = model[indexOf(p.id[i])];
      if (x.owner == comm.rank() && !x.gone) continue;
      m.departed.push_back(i);
      m.departedTo.push_back(x.gone ? -1 : x.owner);
      changedHere = changedHere || x.gone;
    }
    for (std::size_t i = 0; i < model.size(); i++)
      if (!model[i].gone && model[i].owner == comm.rank() && before[i] != comm.rank()) {
        addParticle(i);
        m.arrivals++;
      }
    halo->migrate(p, s, b, m);
    sort(m.departed);
  }
  void remove(std::size_t i) {
    model[i].solid = false;
    model[i].markExposed = false;
    model[i].bonds.clear();
    erase([&](std::uint64_t, std::uint64_t to) { return to == idOf(i); });
  }

  /// Removes bonds (id, id of the other end) that fulfil `is`, and exposes their ends.
  template<class Is> void erase(Is is) {
    for (std::size_t i = 0; i < model.size(); i++)
      if (std::erase_if(model[i].bonds, [&](const ModelBond& x) { return is(idOf(i), x.to); }) > 0)
        model[i].markExposed = true;
  }

  void meltAndFreeze(double melt, double freeze) {
    std::vector<std::uint8_t> turned(model.size(), 0);
    for (std::size_t i = 0; i < model.size(); i++) {
      if (model[i].gone || turnedBefore.count(i) > 0)
        continue;  // a phase changes at most once between two rebuilds of bonds
      if (model[i].solid && dice.chance(melt)) {
        remove(i);
        turned[i] = 1;
      } else if (!model[i].solid && dice.chance(freeze)) {
        model[i].solid = true;
        turned[i] = 1;
      }
    }
    for (std::size_t i = 0; i < model.size(); i++)
      if (turned[i]) turnedBefore.insert(i);
    for (std::size_t i = 0; i < p.owned; i++) {
      const std::size_t k = indexOf(p.id[i]);
      if (!turned[k]) continue;
      p.phase[i] = model[k].solid ? Solid : Liquid;
      changedHere = true;
    }
  }

  void breakSome(double chance) {
    std::set<std::pair<std::uint64_t, std::uint64_t>> broken;
    const auto key = [](std::uint64_t i, std::uint64_t j) {
      return std::pair{std::min(i, j), std::max(i, j)};
    };
    for (std::size_t i = 0; i < model.size(); i++)
      for (const ModelBond& x : model[i].bonds)
        if (dice.chance(chance)) broken.insert(key(idOf(i), x.to));
    erase([&](std::uint64_t from, std::uint64_t to) { return broken.count(key(from, to)) > 0; });
    for (std::size_t solidIndex = 0; solidIndex < s.owned; solidIndex++)
      for (int k = 0; k < b.capacity; k++) {
        const std::size_t at = b.at(solidIndex, k);
        if (!(b.weight[at] > 0) || broken.count(key(s.id[solidIndex], s.id[b.neighbour[at]])) == 0) continue;
        b.weight.set(at, 0);
        b.broken = true;
        s.markExposed(solidIndex);
        s.changed[solidIndex] = 1;
      }
  }

  /// Random bonds with one or both ends, also to liquid particles and to themselves.
  std::vector<BondRequest> requests(std::size_t count, double oneEnded) {
    std::vector<BondRequest> mine;
    for (std::size_t n = 0; n < count; n++) {
      const std::size_t i = dice.below(model.size()), j = dice.below(model.size());
      const double weight = 1 + static_cast<double>(dice.below(1000));
      request(i, j, weight, mine);
      if (!dice.chance(oneEnded) && i != j) request(j, i, weight, mine);
    }
    return mine;
  }
  void request(std::size_t from, std::size_t to, double weight, std::vector<BondRequest>& mine) {
    if (model.empty() || !model[from].solid) return;
    if (model[from].owner == comm.rank()) {
      const BondRecord r = randomBond(idOf(from), idOf(to), weight);
      const std::uint32_t solidIndex = halo->graph().rowOf(idOf(from));
      mine.push_back({solidIndex,
                      r.neighbourId,
                      {r.reference[0], r.reference[1], r.reference[2]},
                      {r.reverse[0], r.reverse[1], r.reverse[2]},
                      weight});
    }
    if (from != to && model[to].solid) model[from].bonds.push_back({idOf(to), weight});
  }

  bool rebuildBonds(const std::vector<BondRequest>& requests = {}) {
    const bool any = halo->rebuildBonds(p, s, b, {requests, changedHere});
    changedHere = false;
    turnedBefore.clear();
    return any;
  }

  static double volumeOf(std::uint64_t id) { return 1 + static_cast<double>(id % 1000); }

  void checkSolids() {
    ASSERT_NO_THROW(halo->graph().check({p, s, b}));
    std::size_t solid = 0;
    for (std::size_t i = 0; i < p.owned; i++) {
      const ModelParticle& m = model[indexOf(p.id[i])];
      ASSERT_EQ(m.owner, comm.rank());
      ASSERT_EQ(p.solidIndex[i] != noSolid, m.solid) << "particle " << indexOf(p.id[i]);
      solid += m.solid;
    }
    ASSERT_EQ(s.owned, solid);
    digest.resize(s.owned, 0);
    for (std::size_t solidIndex = 0; solidIndex < s.owned; solidIndex++) {
      const std::uint64_t id = s.id[solidIndex];
      const ModelParticle& m = model[indexOf(id)];
      ASSERT_EQ(p.id[s.particle[solidIndex]], id);
      ASSERT_EQ(s.material[solidIndex], indexOf(id) % 5);
      if (s.volume[solidIndex] == 0) {  // became solid in this step
        ASSERT_TRUE(s.plasticInverse[solidIndex].row[0].y == 0);
        s.volume[solidIndex] = volumeOf(id);
        s.plasticInverse[solidIndex].row[0].y = -volumeOf(id);
      }
      ASSERT_EQ(s.volume[solidIndex], volumeOf(id));
      ASSERT_EQ(s.plasticInverse[solidIndex].row[0].y, -volumeOf(id));
      ASSERT_EQ(s.exposed[solidIndex] != 0, m.markExposed) << "particle " << indexOf(id);
      std::size_t n = 0;
      std::uint64_t sum = 0;
      for (int k = 0; k < b.capacity; k++) {
        const std::size_t at = b.at(solidIndex, k);
        if (!(b.weight[at] > 0)) continue;
        ASSERT_LT(n, m.bonds.size()) << "particle " << indexOf(id);
        const ModelBond& e = m.bonds[n++];
        const BondRecord r = randomBond(id, e.to, e.weight);
        ASSERT_LT(b.neighbour[at], s.size());
        ASSERT_EQ(s.id[b.neighbour[at]], e.to);
        ASSERT_EQ(b.weight[at], e.weight);
        ASSERT_TRUE(b.x[at] == r.reference[0] && b.y[at] == r.reference[1] && b.z[at] == r.reference[2]);
        ASSERT_TRUE(b.rx[at] == r.reverse[0] && b.ry[at] == r.reverse[1] && b.rz[at] == r.reverse[2]);
        sum = spreadBits(sum + e.to) + static_cast<std::uint64_t>(e.weight) * 2 +
              (b.neighbour[at] >= s.owned);
      }
      ASSERT_EQ(n, m.bonds.size()) << "particle " << indexOf(id);
      if (s.changed[solidIndex]) digest[solidIndex] = sum;
      s.changed[solidIndex] = 0;
      ASSERT_EQ(digest[solidIndex], sum) << "Solids::changed was not set";
    }
  }

  /// Checks that remote rows equal their owners' and that only remote rows are sent.
  void checkExchange() {
    const std::uint64_t salt = dice.next();
    for (std::size_t r = 0; r < s.size(); r++) {
      const bool own = r < s.owned;
      s.position[r] = own ? Vec3d{number(s.id[r], salt, 0), number(s.id[r], salt, 1), 1} : Vec3d{};
      s.liquid[r] = own ? static_cast<float>(s.id[r] % 97) : -1;
    }
    const std::int64_t before = comm.statistics()[MessagesFor::Bonds].bytes;
    AnyColumn* columns[] = {&s.liquid, &s.position};
    halo->begin(s, columns);
    halo->finish(s);
    std::int64_t sums[2] = {comm.statistics()[MessagesFor::Bonds].bytes - before,
                            static_cast<std::int64_t>(s.ghosts) * 28};
    MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_INT64_T, MPI_SUM, comm.handle());
    ASSERT_EQ(sums[0], sums[1]);
    for (std::size_t r = s.owned; r < s.size(); r++) {
      ASSERT_TRUE((s.position[r] == Vec3d{number(s.id[r], salt, 0), number(s.id[r], salt, 1), 1}))
          << "remote row of particle " << indexOf(s.id[r]);
      ASSERT_EQ(s.liquid[r], static_cast<float>(s.id[r] % 97));
    }
  }

  /// Returns false on all ranks if a check fails on any, so that no rank waits for a failed one.
  bool good(const char* where) {
    SCOPED_TRACE(where);
    checkSolids();
    if (!agree()) return false;
    checkExchange();
    return agree();
  }
  bool agree() {
    int bad = testing::Test::HasFailure();
    MPI_Allreduce(MPI_IN_PLACE, &bad, 1, MPI_INT, MPI_MAX, comm.handle());
    return bad == 0;
  }
};

}  // namespace thaw::test
