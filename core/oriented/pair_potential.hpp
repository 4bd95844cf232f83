// The energy of a pair of oriented particles and its derivatives (ST92). Pure functions of the pair.
#pragma once
#include <cmath>

#include "core/scene/oriented_body.hpp"

namespace thaw {

/// The constants of one body's potential, made from its scene table.
struct PairPotential {
  double spacing = 1;  ///< m, s: the spacing at which a hexagonal lattice is at rest
  double reach = 3;    ///< m, support radius: the energy is 0 from here on
  double fade = 2.25;  ///< m, where it begins to fade
  double scale = 1;    ///< J, stiffness times s^2
  double well = 1;     ///< m, distance at which Lennard-Jones of a pair is least
  double core = 0.7;   ///< m, below this it goes on as a straight line (B33)
  int n = 12, m = 6;   ///< its powers
  double attract = 1, plane = 1, normal = 1, circle = 1;  ///< weights
  double a = 1, b = 0.5;  ///< m, scales of the weighting function across and along the normal
  bool facing = true;     ///< see OrientedBody
};

/// Makes the constants. `well` is such that the hexagonal lattice of this spacing has no tension: with the
/// full sum of 12-6 it is s / (1.11146 2^(-1/6)).
PairPotential pairPotential(const OrientedBody& body, double spacing);

/// What a pair gives its first particle. r = x_j - x_i (m).
struct PairResult {
  double energy = 0;         ///< J, of the pair
  Vec3d force{};             ///< N, on i; that on j is its negative
  Vec3d torque{};            ///< N m, on i
  double stiffness = 0;      ///< N/m, bound of its second derivative by places
  double turnStiffness = 0;  ///< N m, by rotations
};

/// Which of the potentials count: particles in a crease have no orientation (ST92, creases).
struct PairKind {
  bool oriented = true;
};

/// Energy, force and torque of a pair: with psi_i = exp(-(d_x^2 + d_y^2)/(2 a^2) - d_z^2/(2 b^2)) of r in i's
/// frame,
///   E = scale fade(r) face(n_i . n_j) (w_A LJ(r) + w_P ((n_i.r)^2 psi_i + (n_j.r)^2 psi_j)/s^2
///       + (w_N |n_i - n_j|^2 + w_C ((n_i + n_j).r)^2/s^2) (psi_i + psi_j)/2).
/// fade goes from 1 to 0 between PairPotential::fade and reach, face from 0 to 1 as n_i . n_j goes from 0 to
/// 1/2 (1 without `facing`).
PairResult pairForces(const PairPotential& p, const Vec3d& r, const Vec3d& ni, const Vec3d& nj,
                      PairKind kind = {});

/// The Lennard-Jones part alone: energy over scale and weight, and its first two derivatives by r (m).
struct RadialPart {
  double energy, slope, curvature;
};
RadialPart radialPart(const PairPotential& p, double r);

/// J a particle, of a flat hexagonal lattice of this spacing (m), and its derivative by the spacing.
struct LatticeEnergy {
  double energy, slope;
};
LatticeEnergy hexagonalEnergy(const PairPotential& p, double spacing);

/// 0 below 0, 1 above 1, with two continuous derivatives; and its slope.
struct Ramp {
  double value, slope;
};
inline Ramp smoothRamp(double t) {
  if (t <= 0) return {0, 0};
  if (t >= 1) return {1, 0};
  return {t * t * t * (10 + t * (6 * t - 15)), 30 * t * t * (1 - t) * (1 - t)};
}

}  // namespace thaw
