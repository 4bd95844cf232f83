// What the implicit viscosity solver works with: reused in every step, nothing of it is part of the state.
#pragma once
#include <vector>

#include "core/fluid/pair_sums.hpp"

namespace thaw {

/// Drag of a wall on one particle: -drag (1 - n n^T) (u - velocity).
struct ViscousWall {
  std::uint32_t row, wall;
  double drag;  ///< kg/s
  Vec3d normal;
  Vec3d velocity;  ///< m/s, of the wall there
  /// N, for u relative to the wall
  Vec3d along(const Vec3d& u) const { return drag * (u - normal * dot(u, normal)); }
};

struct ViscousWork {
  AlignedVector<ViscousRecord> records, middle;  ///< all rows and the dummy
  std::vector<ViscousWall> walls;                ///< by row, then wall
  std::vector<Vec3d> goal;                       ///< m/s, velocity without viscosity
  std::vector<Vec3d> solution;                   ///< m/s, with it
  std::vector<Vec3d> residual;                   ///< kg m/s
  std::vector<Vec3d> product;                    ///< N, then kg m/s: the operator times something
  std::vector<Vec3d> ready;                      ///< m/s, preconditioned residual
  std::vector<Sym3d> block;                      ///< kg/s, then 1/kg: inverse of the particle's own 3x3 block
  int iterations = 0;                            ///< of the last step
};

}  // namespace thaw
