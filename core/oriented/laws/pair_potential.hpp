// SPDX-License-Identifier: Apache-2.0
// Pair potential of oriented particles and its derivatives (ST92). Pure functions of the pair.
#pragma once
#include <cmath>

#include "core/scene/oriented_body.hpp"

namespace thaw {

/// Constants of one body's potential, from its scene table.
struct PairPotential {
  double spacing = 1;  ///< m, s, spacing at which a hexagonal lattice is at rest
  double reach = 3;    ///< m, support radius, beyond which the energy is 0
  double fade = 2.25;  ///< m, distance at which the fade-out begins
  double scale = 1;    ///< J, stiffness times s^2
  double well = 1;     ///< m, distance of the Lennard-Jones minimum of a pair
  double core = 0.7;   ///< m, distance below which Lennard-Jones is linear (docs/validation/stability.md, row
                       ///< 33)
  int n = 12, m = 6;   ///< exponents of Lennard-Jones
  double attract = 1, plane = 1, normal = 1, circle = 1;  ///< weights
  double a = 1, b = 0.5;  ///< m, scales of the weighting function across and along the normal
  bool facing = true;     ///< see OrientedBody
};

/// Computes the constants. `well` makes the hexagonal lattice of this spacing free of tension. For the full
/// 12-6 sum it is s / (1.11146 2^(-1/6)).
PairPotential pairPotential(const OrientedBody& body, double spacing);

/// Result of a pair for its first particle, with r = x_j - x_i (m).
struct PairResult {
  double energy = 0;         ///< J, energy of the pair
  Vec3d force{};             ///< N, on i; the force on j is its negative
  Vec3d torque{};            ///< N m, on i
  double stiffness = 0;      ///< N/m, bound of the second derivative with respect to position
  double turnStiffness = 0;  ///< N m, bound of the second derivative with respect to rotation
};

/// Selects the potentials: creased particles have no orientation (ST92).
struct PairKind {
  bool oriented = true;
};

/// Returns energy, force and torque of a pair. With psi_i = exp(-(d_x^2 + d_y^2)/(2 a^2) - d_z^2/(2 b^2)),
/// where d is r in i's frame,
///   E = scale fade(r) face(n_i . n_j) (w_A LJ(r) + w_P ((n_i.r)^2 psi_i + (n_j.r)^2 psi_j)/s^2
///       + (w_N |n_i - n_j|^2 + w_C ((n_i + n_j).r)^2/s^2) (psi_i + psi_j)/2).
/// fade falls from 1 to 0 between PairPotential::fade and reach. face rises from 0 to 1 as n_i . n_j
/// increases from 0 to 1/2; it is 1 without `facing`.
PairResult pairForces(const PairPotential& p, const Vec3d& r, const Vec3d& ni, const Vec3d& nj,
                      PairKind kind = {});

/// Lennard-Jones energy over scale and weight, with its first two derivatives with respect to r (m).
struct RadialPart {
  double energy, slope, curvature;
};
RadialPart radialPart(const PairPotential& p, double r);

/// Energy per particle (J) of a flat hexagonal lattice with this spacing (m), and its derivative with respect
/// to the spacing (N).
struct LatticeEnergy {
  double energy, slope;
};
LatticeEnergy hexagonalEnergy(const PairPotential& p, double spacing);

/// Smooth step from 0 at t = 0 to 1 at t = 1, with two continuous derivatives, and its slope.
struct Ramp {
  double value, slope;
};
inline Ramp smoothRamp(double t) {
  if (t <= 0) return {0, 0};
  if (t >= 1) return {1, 0};
  return {t * t * t * (10 + t * (6 * t - 15)), 30 * t * t * (1 - t) * (1 - t)};
}

}  // namespace thaw
