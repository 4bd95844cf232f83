// What the incompressible pressure solver works with; nothing of it is part of the state.
#pragma once
#include <cstdint>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

/// A wall as the filling of a liquid particle sees it.
struct WallSlope {
  std::uint32_t row;
  Vec3d slope;     ///< 1/m, of the filling by the particle's place: towards the wall
  Vec3d velocity;  ///< m/s, of the wall
};

/// What liquid in motion without a free surface fills beside what sliding layers do: it cannot make room for
/// itself, and with less it jams. Vortices of Re 100, 50 spacings long, keep .0016 of their energy without
/// it, .50 with .005, .65 with .01, .70 with .02 and .69 with .03.
inline constexpr double flowingExcess = 0.02;

struct PressureWork {
  double full = 1;  ///< filling from which on liquid resists: that of layers that slide over each other,
                    ///< which fill a little more than at rest
  double relaxation = 0;         ///< share of a Jacobi step that does not overshoot on the lattice
  double mendingTime = 0;        ///< s, in which a compression is undone: that of the fastest expected over a
                                 ///< spacing
  std::vector<WallSlope> walls;  ///< by row
  std::vector<double> response;  ///< 1/(Pa s^2), of the rate of a particle's filling to its own pressure over
                                 ///< the step, by its liquid fraction; 0: no liquid
  std::vector<float> fraction;   ///< liquid
  std::vector<float> before, stepped;  ///< Pa s, after the last step and after this one, without momentum
  std::vector<Vec3d> start;            ///< m/s, velocities before the solve
  std::vector<Vec3d> arrived;          ///< m/s, velocities before both
  std::vector<Vec3d> impulse;          ///< N s
  std::vector<double> rate;            ///< 1/s, of the filling
};

}  // namespace thaw
