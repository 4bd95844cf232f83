// The moment matrix A = sum w X X^T of a particle's bonds, and what to do where it has no inverse: sheets,
// rows, lonely particles.
#pragma once
#include "core/math/mat3.hpp"

namespace thaw {

/// Directions whose eigenvalue is less than this times the largest one count as missing: neighbours that lie
/// within a tenth of their distance of a plane (line) do not measure the strain across it, and the stiffness
/// of such short levers would bound the time step.
inline constexpr double momentCutoff = 0.01;

struct MomentInverse {
  Sym3d inverse{};  ///< A^-1, or its pseudo-inverse, 1/m^2
  int rank = 0;     ///< 3: regular; 2: sheet; 1: row; 0: no bonds
};

/// Inverse of A (m^2).
MomentInverse invertMoment(const Sym3d& a, double cutoff = momentCutoff);

/// Displacement gradient of a particle whose A has rank < 3. `gradU` is the plain sum (sum w u X^T) A^+,
/// which lacks what lies across the plane or line. Completed so that these directions turn along without
/// strain: by the cross product of the in-plane images (rank 2), by the smallest rotation of the line (rank
/// 1), zero (rank 0).
Mat3d completeGradient(const Mat3d& gradU, const Sym3d& momentInverse, int rank);

/// A neighbourhood of rank 2 whose gradient is completed, and what its energy does with that.
struct FlatNeighbourhood {
  Mat3d gradU{};  ///< completed
  Sym3d momentInverse{};
  double trace = 0;    ///< m^2, of A
  Mat3d sum{};         ///< m^2, sum w u X^T over all bonds
  Mat3d stress{};      ///< J, V P of the completed gradient
  double penalty = 0;  ///< N/m, k of the hourglass control
};
/// J, to be added to V P: the completed normal n' turns with the plane, so that the energy depends on the
/// plane's images by it, too. With y = dE/dn' = V P n - k sum_j w_j (X_j n) (x_j - F X_j) this is y dn'/dF.
/// The fit makes the penalty stationary for what A measures, not for n'; neighbours that lie off their plane
/// by up to a tenth of their distance pull at it. Without this their forces are no derivative: frozen crumbs
/// got energy and spin from nowhere.
Mat3d stressOfNormal(const FlatNeighbourhood& flat);

}  // namespace thaw
