// The moment matrix A = sum w X X^T of a particle's bonds, and what to do where it has no inverse: sheets, rows, lonely particles.
#pragma once
#include "core/math/mat3.hpp"

namespace thaw {

/// Directions whose eigenvalue is less than this times the largest one count as missing: neighbours that lie within a tenth
/// of their distance of a plane (line) do not measure the strain across it, and the stiffness of such short levers would
/// bound the time step.
inline constexpr double momentCutoff = 0.01;

struct MomentInverse {
  Sym3d inverse{};        ///< A^-1, or its pseudo-inverse, 1/m^2
  int rank = 0;           ///< 3: regular; 2: sheet; 1: row; 0: no bonds
};

/// Inverse of A (m^2).
MomentInverse invertMoment(const Sym3d& a, double cutoff = momentCutoff);

/// Displacement gradient of a particle whose A has rank < 3. `gradU` is the plain sum (sum w u X^T) A^+, which lacks what
/// lies across the plane or line. Completed so that these directions turn along without strain: by the cross product of the in-plane images
/// (rank 2), by the smallest rotation of the line (rank 1), zero (rank 0).
Mat3d completeGradient(const Mat3d& gradU, const Sym3d& momentInverse, int rank);

}  // namespace thaw
