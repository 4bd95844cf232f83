// SPDX-License-Identifier: Apache-2.0
// Work arrays of the implicit viscosity solver, reused in each step. They are not part of the state.
#pragma once
#include <vector>

#include "core/fluid/pair_sums/pair_sums.hpp"

namespace thaw {

/// Drag of a wall on one particle: -drag (1 - n n^T) (u - velocity).
struct ViscousWall {
  std::uint32_t row, wall;
  double drag;  ///< kg/s
  Vec3d normal;
  Vec3d velocity;  ///< m/s, velocity of the wall there
  /// Drag (N) for u relative to the wall.
  Vec3d along(const Vec3d& u) const { return drag * (u - normal * dot(u, normal)); }
};

struct ViscousWork {
  AlignedVector<ViscousRecord> records, middle;  ///< all rows and the dummy
  std::vector<ViscousWall> walls;                ///< by row, then wall
  std::vector<Vec3d> goal;                       ///< m/s, velocity without viscosity
  std::vector<Vec3d> solution;                   ///< m/s, velocity with viscosity
  std::vector<Vec3d> residual;                   ///< kg m/s
  std::vector<Vec3d> product;                    ///< N, then kg m/s: result of the operator
  std::vector<Vec3d> ready;                      ///< m/s, preconditioned residual
  std::vector<Sym3d> block;                      ///< kg/s, then 1/kg: inverse of the particle's own 3x3 block
  int iterations = 0;                            ///< number in the last step
};

}  // namespace thaw
