// SPDX-License-Identifier: Apache-2.0
// Work arrays of the incompressible pressure solver. They are not part of the state.
#pragma once
#include <cstdint>
#include <vector>

#include "core/math/mat3.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

/// Contribution of a wall to the relative density of a liquid particle.
struct WallSlope {
  std::uint32_t row;
  Vec3d slope;     ///< 1/m, gradient with respect to the particle's position: towards the wall
  Vec3d velocity;  ///< m/s, of the wall
};

/// Extra target density for flow without a free surface, which cannot expand and would otherwise jam. The
/// summed densities of disordered particles are larger than those of a lattice and scatter by 2 %.
inline constexpr double flowDensityExcess = 0.03;

struct PressureWork {
  double targetRelativeDensity = 1;  ///< relative density of sliding layers, slightly above that at rest
  bool closed = false;               ///< liquid without a free surface, which cannot expand
  double relaxation = 0;             ///< fraction of a Jacobi step that does not overshoot on the lattice
  double correctionTime = 0;  ///< s, correction time of a compression: one spacing over the largest expected
                              ///< speed
  std::vector<WallSlope> walls;  ///< by row
  std::vector<double> response;  ///< 1/(Pa s^2), derivative of a particle's density rate with respect to its
                                 ///< pressure impulse (Pa s), times liquid fraction; 0: no liquid
  std::vector<float> fraction;   ///< liquid fraction
  std::vector<float> before, stepped;  ///< Pa s, after the previous and the current step, without momentum
  std::vector<Vec3d> start;            ///< m/s, velocities before the solve
  std::vector<Vec3d> arrived;          ///< m/s, velocities before both solves
  std::vector<Vec3d> impulse;          ///< N s
  std::vector<Sym3d> moment;           ///< 1, of the neighbourhood
  std::vector<Sym3d> otherResponse;    ///< 1/(m^2 kg), PairSums::otherResponse
  std::vector<float> inside;           ///< 1, weight of the gradient correction: 1 inside the liquid
  std::vector<double> rate;            ///< 1/s, rate of the relative density
};

}  // namespace thaw
