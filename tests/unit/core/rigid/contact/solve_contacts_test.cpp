// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/solve_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/halo/serial.hpp"
#include "tests/support/rigid/thread_ranks.hpp"

namespace thaw {
namespace {

struct Problem {
  std::vector<PieceMotion> pieces;
  std::vector<RigidContact> contacts;
};

/// A random net of contacts among pieces whose masses differ up to a hundredfold, and with an obstacle.
Problem randomNet(int pieces, int contacts) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3d{unit(random), unit(random), unit(random)}; };
  Problem p;
  for (int i = 0; i < pieces; i++) {
    const double inverse = std::pow(10.0, unit(random)), turning = 6 * inverse;
    p.pieces.push_back({inverse, {turning, turning, turning, 0, 0, 0}, vector(), vector(), vector()});
  }
  for (int k = 0; k < contacts; k++) {
    RigidContact c;
    c.a = static_cast<std::uint32_t>(k % pieces);
    c.b = k % 3 == 0 ? noPiece : static_cast<std::uint32_t>((k + 1 + k / pieces) % pieces);
    if (c.b == c.a) c.b = noPiece;
    c.armA = 0.5 * vector();
    c.armB = 0.5 * vector();
    c.normal = normalized(vector());
    c.gap = 1e-4 * unit(random);
    c.friction = 0.4;
    c.restitution = k % 2 ? 0.3 : 0;
    if (c.b == noPiece) c.otherVelocity = 0.1 * vector();
    c.rolling = k % 4 ? 0 : 0.05;
    if (c.b == noPiece) c.otherSpin = 0.1 * vector();
    c.keyA = static_cast<std::uint64_t>(k);
    p.contacts.push_back(c);
  }
  return p;
}

ContactSettings settingsOf() {
  ContactSettings s;
  s.step = 1e-3;
  s.tolerance = 1e-6;
  s.impactSpeed = 1e-2;
  s.slop = 1e-6;
  s.mostCorrection = 1e-3;
  return s;
}

struct Solution {
  ContactResult result;
  std::vector<PieceChange> changes;
};

Solution solve(Problem& p, const ContactSettings& settings) {
  SerialReducer all;
  SerialPieceExchange exchange;
  Solution s;
  s.changes.resize(p.pieces.size());
  s.result = solveContacts(p.pieces, p.contacts, settings, exchange, all, s.changes);
  return s;
}

void expectSameBits(const Vec3d& a, const Vec3d& b) { EXPECT_TRUE(a == b) << a.x << ' ' << b.x; }

double energyOf(const Problem& p) {
  double e = 0;
  for (const PieceMotion& m : p.pieces)
    e += 0.5 * (dot(m.velocity, m.velocity) / m.inverseMass + dot(m.spin, m.spin) / m.inverseInertia.xx);
  return e;
}

TEST(SolveContacts, TheOrderOfContactsDoesNotChangeABit) {
  Problem a = randomNet(20, 60), b = a;
  std::shuffle(b.contacts.begin(), b.contacts.end(), std::mt19937(3));
  const Solution sa = solve(a, settingsOf()), sb = solve(b, settingsOf());
  EXPECT_EQ(sa.result.iterations, sb.result.iterations);
  EXPECT_EQ(sa.result.dissipated, sb.result.dissipated);
  for (std::size_t i = 0; i < a.pieces.size(); i++) {
    expectSameBits(a.pieces[i].velocity, b.pieces[i].velocity);
    expectSameBits(a.pieces[i].spin, b.pieces[i].spin);
    expectSameBits(sa.changes[i].shift, sb.changes[i].shift);
  }
}

TEST(SolveContacts, TheRanksOfContactsDoNotChangeABit) {
  const Problem start = randomNet(20, 60);
  Problem serial = start;
  ContactSettings settings = settingsOf();
  settings.mostIterations = 30;  // few, since threads that wait for each other are slow
  const Solution expected = solve(serial, settings);
  EXPECT_GT(expected.result.iterations, 3);
  for (const int count : {2, 3, 5}) {
    ThreadRanks ranks(count);
    ranks.run([&](int rank) {
      // each rank has a part of the contacts, and its own order of rows
      Problem mine;
      std::vector<std::uint64_t> ids;
      std::vector<std::uint32_t> rowOf(start.pieces.size());
      for (std::size_t k = 0; k < start.pieces.size(); k++) {
        const std::size_t i = (k * 7 + static_cast<std::size_t>(rank)) % start.pieces.size();
        rowOf[i] = static_cast<std::uint32_t>(mine.pieces.size());
        ids.push_back(i);
        mine.pieces.push_back(start.pieces[i]);
      }
      for (std::size_t k = 0; k < start.contacts.size(); k++) {
        if (static_cast<int>(k * k % static_cast<std::size_t>(count)) != rank) continue;
        RigidContact c = start.contacts[k];
        c.a = rowOf[c.a];
        if (c.b != noPiece) c.b = rowOf[c.b];
        mine.contacts.push_back(c);
      }
      ThreadReducer all(ranks, rank);
      ThreadPieceExchange exchange(ranks, rank, ids);
      std::vector<PieceChange> changes(ids.size());
      const ContactResult result = solveContacts(mine.pieces, mine.contacts, settings, exchange, all,
                                                 changes);
      EXPECT_EQ(result.iterations, expected.result.iterations);
      EXPECT_EQ(result.dissipated, expected.result.dissipated);
      for (std::size_t k = 0; k < ids.size(); k++) {
        expectSameBits(mine.pieces[k].velocity, serial.pieces[ids[k]].velocity);
        expectSameBits(mine.pieces[k].spin, serial.pieces[ids[k]].spin);
        expectSameBits(changes[k].turn, expected.changes[ids[k]].turn);
      }
    });
  }
}

TEST(SolveContacts, IslandsDoNotAffectEachOther) {
  // two nets that touch the same prescribed piece
  const auto net = [](int seed) {
    Problem p = randomNet(10, 25);
    for (PieceMotion& m : p.pieces) m.velocity = static_cast<double>(seed) * m.velocity;
    p.pieces.emplace_back();
    for (std::size_t k = 0; k < p.contacts.size(); k += 5) p.contacts[k].b = 10;
    return p;
  };
  Problem first = net(1), second = net(3), both = first;
  for (std::size_t r = 0; r < 10; r++) both.pieces.push_back(second.pieces[r]);
  for (RigidContact c : second.contacts) {
    c.a += 11;
    if (c.b != noPiece && c.b != 10) c.b += 11;
    c.keyA += 100;
    both.contacts.push_back(c);
  }
  const Solution a = solve(first, settingsOf()), b = solve(second, settingsOf()),
                 ab = solve(both, settingsOf());
  EXPECT_EQ(ab.result.iterations, std::max(a.result.iterations, b.result.iterations));
  for (std::size_t r = 0; r < 10; r++) {
    expectSameBits(both.pieces[r].velocity, first.pieces[r].velocity);
    expectSameBits(both.pieces[r + 11].velocity, second.pieces[r].velocity);
    expectSameBits(ab.changes[r + 11].shift, b.changes[r].shift);
  }
  EXPECT_TRUE(both.pieces[10].velocity == Vec3d{});
}

TEST(SolveContacts, ContactsFulfilSignoriniAndCoulomb) {
  Problem p = randomNet(20, 30);
  for (RigidContact& c : p.contacts) c.restitution = 0;
  const ContactSettings settings = settingsOf();
  const Solution s = solve(p, settings);
  ASSERT_TRUE(s.result.converged) << s.result.residual;
  for (const RigidContact& c : p.contacts) {
    const Vec3d other = c.b == noPiece ? c.otherVelocity : velocityAtArm(p.pieces[c.b], c.armB);
    const Vec3d u = velocityAtArm(p.pieces[c.a], c.armA) - other;
    const double un = dot(u, c.normal) + std::max(0.0, c.gap) / settings.step;
    const double pressing = dot(c.impulse, c.normal);
    const Vec3d slide = u - dot(u, c.normal) * c.normal, rub = c.impulse - pressing * c.normal;
    EXPECT_GE(un, -1e-4);
    EXPECT_GE(pressing, 0);
    EXPECT_LE(length(rub), c.friction * pressing * (1 + 1e-9));
    if (pressing > 1e-3) { EXPECT_LE(un, 1e-4); }
    if (pressing > 1e-3 && length(slide) > 1e-3) {
      EXPECT_NEAR(dot(rub, slide), -c.friction * pressing * length(slide), 1e-2 * pressing * length(slide));
    }
  }
}

// The accelerations leave the cones between sweeps, and the iteration may end in any turn.
TEST(SolveContacts, ImpulsesAreInTheirConesWithoutConvergence) {
  for (const int most : {1, 5, 30, 37, 150}) {
    Problem p = randomNet(6, 24);
    ContactSettings settings = settingsOf();
    settings.tolerance = 1e-15;
    settings.mostIterations = most;
    solve(p, settings);
    for (const RigidContact& c : p.contacts) {
      const double normal = dot(c.impulse, c.normal);
      EXPECT_GE(normal, -1e-12 * length(c.impulse));
      EXPECT_LE(length(c.impulse - normal * c.normal), c.friction * normal + 1e-12 * length(c.impulse));
    }
  }
}

TEST(SolveContacts, MomentumOfTwoPiecesIsConservedToRounding) {
  Problem p = randomNet(2, 1);
  p.contacts[0].b = 1;
  p.contacts[0].armA = p.pieces[0].centre * -1.0;
  p.contacts[0].armB = p.pieces[1].centre * -1.0;  // both meet at the origin
  p.contacts[0].normal = normalized(p.pieces[1].velocity - p.pieces[0].velocity);
  p.contacts[0].restitution = 0.5;
  const Solution s = solve(p, settingsOf());
  const Vec3d &j = s.changes[0].impulse, &k = s.changes[1].impulse;
  EXPECT_GT(length(j), 0.1);
  EXPECT_LT(length(j + k), 1e-14 * length(j));
  const Vec3d twist = s.changes[0].angularImpulse + cross(p.pieces[0].centre, j) +
                      s.changes[1].angularImpulse + cross(p.pieces[1].centre, k);
  EXPECT_LT(length(twist), 1e-14 * length(j));
}

TEST(SolveContacts, DissipationIsTheKineticEnergyThatIsMissing) {
  Problem p = randomNet(20, 60);
  const double before = energyOf(p);
  const Solution s = solve(p, settingsOf());
  EXPECT_NEAR(before - energyOf(p), s.result.dissipated - s.result.obstacleWork, 1e-12 * before);
  EXPECT_GT(s.result.dissipated, 0);
}

TEST(SolveContacts, AFreeParticleIsPushedWithItsMass) {
  // a row without inertia of rotation: 1 kg at 1 m/s against 3 kg at rest, inelastic
  Problem p;
  p.pieces.resize(2);
  p.pieces[0].inverseMass = 1;
  p.pieces[0].velocity = {1, 0, 0};
  p.pieces[1].inverseMass = 1.0 / 3;
  RigidContact c;
  c.b = 1;
  c.normal = {-1, 0, 0};
  p.contacts.push_back(c);
  solve(p, settingsOf());
  EXPECT_NEAR(p.pieces[0].velocity.x, 0.25, 1e-6);
  EXPECT_NEAR(p.pieces[1].velocity.x, 0.25, 1e-6);
}

TEST(SolveContacts, AMovingObstacleDoesWork) {
  Problem p;
  p.pieces.resize(1);
  p.pieces[0].inverseMass = 0.5;
  RigidContact c;
  c.normal = {0, 0, 1};
  c.otherVelocity = {0, 0, 2};
  p.contacts.push_back(c);
  const Solution s = solve(p, settingsOf());
  EXPECT_NEAR(p.pieces[0].velocity.z, 2, 1e-6);
  EXPECT_NEAR(s.result.obstacleWork, 8, 1e-5);  // impulse of 4 N s times 2 m/s
  EXPECT_NEAR(s.result.dissipated, 4, 1e-5);
  EXPECT_NEAR(s.result.obstacleImpulse.z, 4, 1e-5);
}

TEST(SolveContacts, OverlapIsRemovedWithoutVelocity) {
  Problem p;
  p.pieces.resize(1);
  p.pieces[0].inverseMass = 1;
  RigidContact c;
  c.normal = {0, 0, 1};
  c.gap = -1e-3;
  p.contacts.push_back(c);
  const Solution s = solve(p, settingsOf());
  EXPECT_TRUE(p.pieces[0].velocity == Vec3d{});
  EXPECT_NEAR(s.changes[0].shift.z, 0.2 * (1e-3 - 1e-6), 2e-6);
}

TEST(SolveContacts, VelocitiesThatAreNotFiniteAreReported) {
  Problem p = randomNet(3, 3);
  p.pieces[0].velocity.x = NAN;
  const Solution s = solve(p, settingsOf());
  EXPECT_FALSE(s.result.converged);
}

/// A tower of ten pieces on four contacts each; the topmost is heavier by `ratio`.
int iterationsOfTower(double ratio, bool warm) {
  const double step = 1e-3;
  std::vector<Vec3d> guess(40);
  int iterations = 0;
  for (int pass = 0; pass < 3; pass++) {
    Problem p;
    for (int i = 0; i < 10; i++) {
      const double inverse = i == 9 ? 1 / ratio : 1, turning = 6 * inverse;
      p.pieces.push_back(
          {inverse, {turning, turning, turning, 0, 0, 0}, {0, 0, i + 0.5}, {0, 0, -9.81 * step}, {}});
      for (int k = 0; k < 4; k++) {
        RigidContact c;
        c.a = static_cast<std::uint32_t>(i);
        c.b = i ? static_cast<std::uint32_t>(i - 1) : noPiece;
        c.armA = {k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, -0.5};
        c.armB = {c.armA.x, c.armA.y, 0.5};
        c.normal = {0, 0, 1};
        c.friction = 0.5;
        c.keyA = p.contacts.size();
        c.impulse = guess[p.contacts.size()];
        p.contacts.push_back(c);
      }
    }
    ContactSettings s = settingsOf();
    s.tolerance = 1e-2 * 9.81 * step;
    const Solution solution = solve(p, s);
    EXPECT_TRUE(solution.result.converged);
    iterations = solution.result.iterations;
    for (std::size_t k = 0; warm && k < guess.size(); k++) guess[k] = p.contacts[k].impulse;
  }
  return iterations;
}

TEST(SolveContacts, TowersConverge) {
  EXPECT_LE(iterationsOfTower(1, false), 100);
  EXPECT_LE(iterationsOfTower(100, false), 400);
  EXPECT_LE(iterationsOfTower(1, true), 3);
  EXPECT_LE(iterationsOfTower(100, true), 30);
}

}  // namespace
}  // namespace thaw
