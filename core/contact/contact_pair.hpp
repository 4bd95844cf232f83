// SPDX-License-Identifier: Apache-2.0
// Properties of two solid particles that touch.
#pragma once
#include <cstdint>

#include "core/math/vec3.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/solids.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Dissipative part of the contact force (N) on a row.
struct DissipativeForce {
  std::uint32_t row = 0;
  Vec3d force;
};

struct ContactPair {
  double stiffness;     ///< N/m, harmonic mean of E * spacing of the two particles
  double restitution;   ///< 1, the smaller value of the two materials
  double friction;      ///< 1, the smaller value of the two materials
  double dashpot;       ///< kg/s
  double frictionRate;  ///< kg/s, largest rate of friction: it stops sliding without reversing it
};

/// step (s): dashpots and friction remove at most a fifth of a pair's velocity in it.
ContactPair contactPair(const Scene& scene, const Continuum& particles, std::uint32_t i, std::uint32_t j,
                        double step);

/// Stiffness (N/m) of contactPair.
double contactStiffness(const Scene& scene, const Continuum& particles, std::uint32_t i, std::uint32_t j);

/// Returns true if both particles are solid and at most one is in a rigid piece. Contacts between rigid
/// pieces are impulses.
bool canTouch(const Continuum& particles, std::uint32_t i, std::uint32_t j);

/// Returns true if owned row i has a bond to row j.
bool hasBondTo(const Solids& solids, const Bonds& bonds, const Continuum& particles, std::uint32_t i,
               std::uint32_t j);

/// Exactly antisymmetric difference (m) of two positions. Requires: positions of periodic images are already
/// shifted.
Vec3d exactDifference(const CellGrid& grid, const Vec3d& a, const Vec3d& b);

}  // namespace thaw
