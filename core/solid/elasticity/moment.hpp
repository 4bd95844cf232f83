// SPDX-License-Identifier: Apache-2.0
// The moment matrix A = sum w X X^T of a particle's bonds, and its treatment if it is singular. It is
// singular in sheets, rows and single particles.
#pragma once
#include "core/math/mat3.hpp"

namespace thaw {

/// Directions with an eigenvalue below this fraction of the largest one count as missing. Neighbours that are
/// off a plane (or line) by less than a tenth of their distance thus do not measure the strain across it. The
/// stiffness of such short levers would limit the time step.
inline constexpr double momentCutoff = 0.01;

struct MomentInverse {
  Sym3d inverse{};  ///< A^-1, or its pseudo-inverse, 1/m^2
  int rank = 0;     ///< 3: regular; 2: sheet; 1: row; 0: no bonds
};

/// Returns the inverse of A (m^2).
MomentInverse invertMoment(const Sym3d& a, double cutoff = momentCutoff);

/// Returns the completed displacement gradient of a particle with rank A < 3. gradU is the plain sum (sum w u
/// X^T) A^+, which lacks the directions across the plane or line. These directions follow the rotation
/// without strain: the cross product of the in-plane images (rank 2), or the smallest rotation of the line
/// (rank 1). Rank 0 gives zero.
Mat3d completeGradient(const Mat3d& gradU, const Sym3d& momentInverse, int rank);

/// A neighbourhood of rank 2 with its completed gradient, and the terms of its energy.
struct FlatNeighbourhood {
  Mat3d gradU{};  ///< completed
  Sym3d momentInverse{};
  double trace = 0;    ///< m^2, of A
  Mat3d sum{};         ///< m^2, sum w u X^T over all bonds
  Mat3d stress{};      ///< J, V P of the completed gradient
  double penalty = 0;  ///< N/m, k of the hourglass control
};
/// Returns a term (J) of V P. The completed normal n' rotates with the plane, so through n' the energy
/// depends on the in-plane images. With y = dE/dn' = V P n - k sum_j w_j (X_j n) (x_j - F X_j) the term is y
/// dn'/dF. The fit makes the penalty stationary for the directions that A measures, not for n'. Neighbours
/// off the plane by up to a tenth of their distance act on n'. Without the term the forces are not a
/// gradient, and frozen fragments gain energy and spin.
Mat3d stressOfNormal(const FlatNeighbourhood& flat);

}  // namespace thaw
