// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/laws/plan_contact.hpp"

#include <algorithm>
#include <cmath>

#include "core/scene/expected_speeds.hpp"

namespace thaw {
namespace {

constexpr double touching = 0.55;    // factor of the sum of the spacings
constexpr double restitution = 0.3;  // restitution of the spring; the barrier is elastic
constexpr double leastRoom = 0.1;    // fraction of the reach, for lattices with wider gaps
// Depth of the barrier for a surface without thickness, in spacings.
constexpr double leastKeep = 0.25;
// Strength of bonds, in units of attract * stiffness * spacing: 1.5 times the largest force of Lennard-Jones
// 12-6.
constexpr double bondPull = 4;

/// Returns the largest speed (m/s) of all surfaces, without falls.
double surfaceSpeed(const Scene& s) {
  double surface = 0;
  for (const OrientedBody& b : s.oriented) {
    surface = std::max(surface, length(b.velocity));
    for (const OrientedConstraint& a : b.constraints) surface = std::max(surface, fastestMove(a.motion));
  }
  return surface;
}

/// Returns the largest contact speed (m/s) between a surface and the continuum.
double contactSpeed(const Scene& s) {
  const double surface = surfaceSpeed(s);
  double other = 0;
  for (const Body& b : s.bodies) other = std::max(other, length(b.velocity));
  for (const Emitter& e : s.emitters) other = std::max(other, e.speed);
  for (const Obstacle& o : s.obstacles) other = std::max(other, fastestMove(o.motion));
  return surface + other + fallSpeed(s.domain);
}

/// Returns the speed of sound (m/s) of a material, for its solid and liquid states.
double soundOf(const Material& m, const LiquidMaterial& liquid) {
  const double solid = m.canBeSolid() ? std::sqrt(std::max(m.young.solid, m.young.liquid) / m.density) : 0;
  return std::max(solid, canBeLiquid(m) ? liquid.soundSpeed : 0);
}

}  // namespace

std::vector<OrientedContact> planOrientedContact(const Scene& s, std::span<const LiquidMaterial> liquids) {
  const double speed = contactSpeed(s);
  std::vector<OrientedContact> all;
  for (const OrientedBody& b : s.oriented) {
    const double own = spacingOf(s, b);
    OrientedContact c;
    c.reach = touching * (own + s.spacing);
    // gap centres of a triangle in the hexagonal lattice and of a square
    c.room = std::max(leastRoom * c.reach,
                      c.reach - std::max(own / std::sqrt(3.0), s.spacing / std::sqrt(2.0)));
    c.spring = b.contact * b.stiffness;
    c.bonds = bondPull * b.attract * b.stiffness * own / c.room;
    c.mass = orientedMass(b, own);
    for (std::size_t m = 0; m < s.materials.size(); m++)
      c.rate.push_back(std::max(2 * speed / c.room, std::sqrt(soundOf(s.materials[m], liquids[m]) * speed /
                                                              (2 * s.spacing * c.room))));
    all.push_back(std::move(c));
  }
  return all;
}

std::vector<ObstacleContact> planObstacleContact(const Scene& s) {
  double speed = surfaceSpeed(s) + fallSpeed(s.domain), obstacles = 0;
  for (const Obstacle& o : s.obstacles) obstacles = std::max(obstacles, fastestMove(o.motion));
  speed += obstacles;
  std::vector<ObstacleContact> all;
  for (const OrientedBody& b : s.oriented) {
    const double own = spacingOf(s, b), keep = b.thickness * own, room = std::max(keep, leastKeep * own);
    all.push_back({keep, room, b.contact * b.stiffness,
                   std::max(bondPull * b.attract * b.stiffness * own / room,
                            orientedMass(b, own) * std::pow(2 * speed / room, 2))});
  }
  return all;
}

ObstacleForce obstacleForceAt(const ObstacleContact& c, double depth) {
  const double d = std::min(depth, c.room), cube = 2 * c.barrier * d * d * d / (c.room * c.room);
  return {c.spring * depth + cube, 0.5 * c.spring * depth * depth + 0.25 * cube * d + cube * (depth - d),
          depth < c.room ? 6 * c.barrier * d * d / (c.room * c.room) : 0};
}

TouchLaw contactLaw(const OrientedContact& c, std::size_t material, double mass, double span) {
  const double both = c.mass * mass / (c.mass + mass),
               barrier = std::max(c.bonds, mass * c.rate[material] * c.rate[material]),
               deep = c.reach / c.room;
  return {std::sqrt(c.spring / both), both, restitution, 0, span, barrier * deep * deep, c.reach};
}

}  // namespace thaw
