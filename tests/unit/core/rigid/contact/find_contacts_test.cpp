// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/find_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "core/rigid/contact/edge_code.hpp"
#include "core/rigid/contact/element_pairs.hpp"
#include "core/rigid/contact/reduce_contacts.hpp"
#include "tests/support/rigid/rig.hpp"
#include "tests/support/rigid/thread_ranks.hpp"

namespace thaw {
namespace {

constexpr double spacing = 0.1;

TEST(SurfaceElements, OfABallHaveItsRadiusAndTouchIt) {
  const double radius = 0.5;
  const SphereDistance ball(radius);
  const RigPiece piece = pieceOf(ball, spacing, 1000);
  int surface = 0;
  for (std::size_t i = 0; i < piece.points.size(); i++) {
    const SurfaceElement& e = piece.elements[i];
    if (!(e.offset > 0)) {
      EXPECT_LT(length(piece.points[i]), radius - spacing);
      continue;
    }
    surface++;
    EXPECT_NEAR(static_cast<double>(e.radius), radius, 1e-6);
    EXPECT_NEAR(length(piece.points[i] + static_cast<double>(e.offset) * wide(e.normal)), radius, 1e-6);
  }
  EXPECT_GT(surface, 200);
}

TEST(SurfaceElements, OfABoxArePlanesWithSharpEdges) {
  const RigPiece piece = pieceOf(BoxDistance({0.6, 0.6, 0.6}), spacing, 1000);
  int planes = 0, edges = 0, corners = 0;
  for (std::size_t i = 0; i < piece.points.size(); i++) {
    const SurfaceElement& e = piece.elements[i];
    if (!(e.offset > 0)) continue;
    EXPECT_FLOAT_EQ(e.offset, 0.05F);
    planes += e.radius == planeRadius;
    if (e.radius > e.offset) continue;
    const Vec3d sharp = piece.points[i] + static_cast<double>(e.offset) * wide(e.normal);
    int faces = 0;
    for (int a = 0; a < 3; a++) faces += std::abs(std::abs(sharp[a]) - 0.3) < 1e-6;
    edges += faces == 2;
    corners += faces == 3;
  }
  EXPECT_EQ(planes, 6 * 16);
  EXPECT_EQ(edges, 12 * 4);
  EXPECT_EQ(corners, 8);
}

TEST(SurfaceElements, OfSmallBallsHaveNoEdges) {
  for (const double radius : {0.1, 0.13, 0.16, 0.19, 0.25}) {
    const RigPiece piece = pieceOf(SphereDistance(radius), spacing, 1000);
    for (std::size_t i = 0; i < piece.points.size(); i++) {
      const SurfaceElement& e = piece.elements[i];
      if (!(e.offset > 0) || e.radius > e.offset) continue;
      const Vec3d sharp = piece.points[i] + static_cast<double>(e.offset) * wide(e.normal);
      EXPECT_LT(length(sharp), radius + 0.01 * spacing) << radius;
    }
  }
}

TEST(SurfaceElements, OfACylinderHaveSharpRims) {
  const RigPiece piece = pieceOf(RevolvedDistance(cylinderOutline(0.4, 0.6)), spacing, 1000);
  int rims = 0;
  for (std::size_t i = 0; i < piece.points.size(); i++) {
    const SurfaceElement& e = piece.elements[i];
    if (!(e.offset > 0) || e.radius > e.offset || e.normal == Vec3f{}) continue;
    const Vec3d sharp = piece.points[i] + static_cast<double>(e.offset) * wide(e.normal);
    EXPECT_NEAR(std::abs(sharp.z), 0.3, 0.05 * spacing);
    EXPECT_NEAR(std::hypot(sharp.x, sharp.y), 0.4, 0.05 * spacing);
    rims++;
  }
  EXPECT_GT(rims, 40);
}

TEST(SurfaceElements, FromNeighboursAreThoseOfTheLattice) {
  const auto elementAt = [](int layersAbove, int besideX) {
    std::vector<Vec3d> around;
    for (int z = -1; z <= layersAbove; z++)
      for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= besideX; x++)
          if (x || y || z) around.push_back({spacing * x, spacing * y, spacing * z});
    return elementOfNeighbours(around, spacing);
  };
  EXPECT_EQ(elementAt(1, 1).offset, 0);  // inside
  const SurfaceElement face = elementAt(0, 1), edge = elementAt(0, 0),
                       lone = elementOfNeighbours({}, spacing);
  EXPECT_NEAR(face.normal.z, 1, 1e-6);
  EXPECT_EQ(face.radius, planeRadius);
  EXPECT_FLOAT_EQ(face.offset, 0.05F);
  EXPECT_TRUE(edge.normal == Vec3f{});
  EXPECT_FLOAT_EQ(edge.radius, 0.05F);
  EXPECT_TRUE(lone.normal == Vec3f{});
  EXPECT_FLOAT_EQ(lone.offset, 0.05F);
}

TEST(SurfaceElements, OfEdgesKeepTheirDirectionAndEnds) {
  const RigPiece piece = pieceOf(BoxDistance({0.8, 0.5, 0.6}), spacing, 1000);
  const Vec3d half{0.4, 0.25, 0.3};
  const Quat turn = rotationBy({0.7, -2.1, 0.4});
  int edges = 0;
  for (std::size_t i = 0; i < piece.points.size(); i++)
    for (const bool turns : {false, true}) {
      const SurfaceElement e = turns ? turned(piece.elements[i], turn) : piece.elements[i];
      if (!(e.radius < 0)) continue;
      SharpEdge edge = edgeOf(e, spacing);
      const Quat back = turns ? conjugate(turn) : Quat{};
      edge.along = rotated(back, edge.along);
      edge.to = rotated(back, edge.to);
      int a = 0;
      while (a < 2 && std::abs(edge.along[a]) < 0.5) a++;
      EXPECT_NEAR(std::abs(edge.along[a]), 1, 1e-7);
      EXPECT_NEAR(edge.to[a], 0, 1e-7);
      const double x = std::copysign(1, edge.along[a]) * piece.points[i][a];
      for (const auto& [found, exact] : {std::pair{edge.ahead, half[a] - x}, {edge.behind, half[a] + x}}) {
        if (exact > 1.65 * spacing) EXPECT_EQ(found, HUGE_VAL);
        else EXPECT_NEAR(found, exact, 0.05 * spacing);
      }
      edges++;
    }
  EXPECT_EQ(edges, 2 * 4 * (6 + 3 + 4));
}

TEST(ElementPairs, TheGapOfFacesDoesNotDependOnTheirOffset) {
  const PlacedElement lower{{0, 0, 0}, {0, 0, 1}, 0.05, 1.0 / 0.0};
  for (const double x : {0.0, 0.03, 0.07}) {
    const PlacedElement upper{{x, 0.5 * x, 0.11}, {0, 0, -1}, 0.05, 1.0 / 0.0};
    const auto c = contactOf(upper, lower, spacing);
    ASSERT_TRUE(c);
    EXPECT_NEAR(c->gap, 0.01, 1e-15);
    EXPECT_NEAR(c->normal.z, 1, 1e-15);
  }
  const PlacedElement away{{0, 0, 0.11}, {0, 0, 1}, 0.05, 1.0 / 0.0};
  EXPECT_FALSE(contactOf(away, lower, spacing));
}

TEST(ElementPairs, SpheresTouchOnTheLineOfTheirCentres) {
  const Vec3d n = normalized(Vec3d{1, 2, 3});
  const PlacedElement a{0.55 * n, -n, 0.05, 0.5}, b{-0.45 * n, n, 0.05, 0.4};
  const auto c = contactOf(a, b, spacing);
  ASSERT_TRUE(c);
  EXPECT_NEAR(c->gap, 0.9, 1e-12);
  EXPECT_LT(length(c->normal - n), 1e-12);
}

/// A cube that stands on another one, turned and shifted.
RigidRig twoCubes() {
  RigidRig rig(spacing, 3, 1e-3);
  rig.setFriction(0.5, 0);
  for (int i = 0; i < 2; i++) {
    rig.pieces.push_back(pieceOf(BoxDistance({0.6, 0.6, 0.6}), spacing, 1000));
    rig.pieces.back().centre = {0.03 * i, 0.02 * i, 0.3 + 0.6 * i};
    rig.pieces.back().orientation = rotationBy({0, 0, 0.3 * i});
  }
  return rig;
}

TEST(FindContacts, FacesTouchAlongTheirNormalAtTheirOutline) {
  RigidRig rig = twoCubes();
  rig.step();
  int between = 0, onFloor = 0;
  double most[2] = {0, 0};
  for (const FoundContact& f : rig.contacts) {
    const bool closed = f.contact.gap < 0.002 * spacing;  // particles above the bevel of an edge are open
    EXPECT_TRUE(!closed || std::abs(std::abs(f.contact.normal.z) - 1) < 1e-6);
    EXPECT_TRUE(!closed || std::abs(f.contact.gap) < 0.02 * spacing);
    (f.contact.b == noPiece ? onFloor : between)++;
    if (f.contact.b != noPiece) continue;
    most[0] = std::max(most[0], f.contact.armA.x + f.contact.armA.y);
    most[1] = std::max(most[1], -f.contact.armA.x - f.contact.armA.y);
  }
  EXPECT_EQ(onFloor, 4);  // the corners of the cube of edge 0.6
  EXPECT_NEAR(most[0], 0.6, 1e-6);
  EXPECT_NEAR(most[1], 0.6, 1e-6);
  EXPECT_GE(between, 4);
  EXPECT_LE(between, 16);  // closed and open ones
}

TEST(FindContacts, BallsHaveNoHolesInAnyDirection) {
  // in the direction of the diagonal of two axes, particles are furthest from the surface of this ball
  for (const Vec3d& inside : {Vec3d{1, 1, 0}, Vec3d{1, 1, 1}, Vec3d{1, 0, 0}, Vec3d{3, 2, 1}}) {
    RigidRig rig(spacing, 3, 1e-3);
    rig.gravity = {};
    rig.setFriction(0, 0);
    const Vec3d from = normalized(inside), axis = cross(from, {0, 0, 1});
    const double sine = length(axis), angle = std::atan2(sine, from.z), half = std::numbers::pi;
    for (int i = 0; i < 2; i++) {
      rig.pieces.push_back(pieceOf(SphereDistance(0.2), spacing, 1000));
      RigPiece& ball = rig.pieces.back();
      ball.centre = {0, 0, 1 + 0.45 * i};
      ball.velocity = {0, 0, i == 0 ? 0.5 : -0.5};
      if (sine > 0) ball.orientation = rotationBy(((angle + i * half) / sine) * axis);
    }
    double deepest = 0;
    for (int n = 0; n < 80; n++) {
      rig.step();
      deepest = std::max(deepest, rig.last.deepest);
    }
    EXPECT_LT(deepest, 0.01 * spacing);
    EXPECT_NEAR(rig.pieces[1].centre.z - rig.pieces[0].centre.z, 0.4, 0.01 * spacing);
  }
}

TEST(FindContacts, ACornerSlidesOnAFaceFromItsEdgeWithoutOverlap) {
  for (const double speed : {0.5, 1.5}) {
    RigidRig rig(spacing, 3, 2e-3);
    rig.setFriction(0, 0);
    rig.pieces.push_back(pieceOf(BoxDistance({1, 1, 0.4}), spacing, 1e5));
    rig.pieces.back().centre = {0, 0, 0.2};
    rig.pieces.push_back(pieceOf(BoxDistance({0.3, 0.3, 0.3}), spacing, 1000));
    RigPiece& cube = rig.pieces.back();
    cube.orientation = rotationBy({0.6, 0.5, 0});
    Vec3d corner{};  // the lowest one
    for (int k = 0; k < 8; k++) {
      const Vec3d sides{k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0};
      const Vec3d at = rotated(cube.orientation, 0.15 * sides);
      if (at.z < corner.z) corner = at;
    }
    cube.centre = {0.505 - corner.x, 0.02, 0.401 - corner.z};
    cube.velocity = {-speed, 0, 0};
    double deepest = 0;
    for (int n = 0; n < 100; n++) {
      rig.step();
      deepest = std::max(deepest, rig.last.deepest);
    }
    EXPECT_LT(deepest, 0.03 * spacing) << speed;
  }
}

TEST(FindContacts, FacesReachTheirCornersAtAnyPlaceInTheGrid) {
  // A cube stands on its corner near the corner of a face, and leans outwards. Its particles are up to 2.3
  // spacings away from those of the face.
  const Vec3d diagonal = normalized(Vec3d{1, 1, 1}), lean{0.5, 0, std::sqrt(0.75)};
  const Vec3d axis = normalized(cross(diagonal, lean));
  for (int place = 0; place < 24; place++) {
    RigidRig rig(spacing, 3, 2e-3);
    rig.setFriction(0, 0);
    const Vec3d top{place * (2 * spacing / 24), 0.02, 1};
    rig.pieces.push_back(pieceOf(BoxDistance({0.6, 0.6, 0.4}), spacing, 1e9));
    rig.pieces[0].orientation = rotationBy({0, 0, 0.25 * std::numbers::pi});
    rig.pieces[0].centre = top - Vec3d{0.3 * std::sqrt(2.0), 0, 0.2};
    rig.pieces.push_back(pieceOf(BoxDistance({0.3, 0.3, 0.3}), spacing, 1000));
    RigPiece& cube = rig.pieces[1];
    cube.orientation = rotationBy(std::acos(dot(diagonal, lean)) * axis);
    cube.centre = top + Vec3d{-0.3 * spacing, 0, 0} + 0.15 * std::sqrt(3.0) * lean;
    for (int n = 0; n < 20; n++) {
      rig.pieces[0].velocity = -rig.settings.step * rig.gravity;
      rig.step();
    }
    const Vec3d corner = cube.centre + rotated(cube.orientation, {-0.15, -0.15, -0.15});
    EXPECT_NEAR(corner.z, top.z, 0.02 * spacing) << place;
  }
}

TEST(FindContacts, ImpulsesAreFirstGuessesOfTheNextStep) {
  RigidRig rig = twoCubes();
  for (int n = 0; n < 20; n++) rig.step();
  rig.step();
  EXPECT_LE(rig.last.iterations, 3);
}

TEST(FindContacts, OneOfTheContactsOfAParticleGetsItsImpulse) {
  Continuum p;
  p.activate(p.contactPartner);
  p.activate(p.contactImpulse);
  p.resize(2, 0);
  p.contactPartner[0] = p.contactPartner[1] = 7;
  p.contactImpulse[0] = {0, 3, 4};
  std::vector<FoundContact> contacts(4);
  for (std::size_t k = 0; k < contacts.size(); k++) {
    contacts[k].partner = k == 2 ? 9 : 7;
    contacts[k].contact.keyB = k;
  }
  contacts[3].particle = 1;
  contacts[0].contact.normal = contacts[3].contact.normal = {0, 1, 0};
  contacts[1].contact.normal = contacts[2].contact.normal = {0, 0, 1};
  guessImpulses(p, contacts);
  EXPECT_TRUE(contacts[1].contact.impulse == (Vec3d{0, 3, 4}));
  for (const std::size_t k : {0, 2, 3}) EXPECT_TRUE(contacts[k].contact.impulse == Vec3d{});
}

TEST(ReduceContacts, TheOutlineIsTheSameOnAnyRanks) {
  // a patch of 15 x 10 points in a plane, and a second one with another partner
  std::vector<FoundContact> patch;
  for (int i = 0; i < 15; i++)
    for (int j = 0; j < 10; j++)
      for (const std::uint64_t partner : {7u, 9u}) {
        FoundContact f;
        f.pieceA = 5;
        f.partner = partner;
        f.contact.normal = {0, 0, -1};
        f.contact.armA = {0.1 * i, 0.1 * j, 0};
        f.contact.gap = i == 3 && j == 4 ? -0.01 : 0;
        f.contact.keyA = 100 * static_cast<std::uint64_t>(i) + static_cast<std::uint64_t>(j);
        f.contact.keyB = partner;
        patch.push_back(f);
      }
  const auto keysOf = [](const std::vector<FoundContact>& contacts) {
    std::set<std::tuple<std::uint64_t, std::uint64_t>> keys;
    for (const FoundContact& f : contacts) keys.insert({f.partner, f.contact.keyA});
    return keys;
  };
  Pieces pieces;
  activatePieces(pieces);
  pieces.resize(1, 0);
  pieces.shared[0] = 1;
  SerialReducer alone;
  std::vector<FoundContact> serial = patch;
  reduceContacts(serial, pieces, spacing, alone);
  const auto expected = keysOf(serial);
  EXPECT_EQ(expected.size(), 2 * 5u);  // four corners and the deepest point, for each partner
  for (const int count : {2, 3}) {
    ThreadRanks ranks(count);
    std::vector<std::vector<FoundContact>> parts(static_cast<std::size_t>(count));
    for (std::size_t k = 0; k < patch.size(); k++) parts[k * k % parts.size()].push_back(patch[k]);
    ranks.run([&](int rank) {
      ThreadReducer all(ranks, rank);
      reduceContacts(parts[static_cast<std::size_t>(rank)], pieces, spacing, all);
    });
    std::vector<FoundContact> together;
    for (const auto& part : parts) together.insert(together.end(), part.begin(), part.end());
    EXPECT_EQ(together.size(), serial.size());
    EXPECT_EQ(keysOf(together), expected);
  }
}

}  // namespace
}  // namespace thaw
