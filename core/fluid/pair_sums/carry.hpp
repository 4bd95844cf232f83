// SPDX-License-Identifier: Apache-2.0
// Input and output of the step of carried densities, the last part of the density sums (terms/carry.hpp).
#pragma once
#include <cstdint>

#include "core/fluid/laws/lattice_relief.hpp"
#include "core/math/mat3.hpp"
#include "core/math/vec3.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct LiquidMaterial;

/// Sums of a particle next to walls, to which the walls' parts are added. Lengths are in support radii.
struct CarryRow {
  double relativeDensity = 0;  ///< 1, summed
  double rate = 0;             ///< 1/s, of the relative density
  Vec3d gradient{};            ///< 1, of the relative density
  Sym3d moment{};              ///< 1; 0 without corrected gradients
  double gradientSize = 0;     ///< 1, h sum V |grad W|
  double liquidFraction = 0;
  bool atSurface = false;  ///< result: at the free surface
};

/// Walls next to particles. Null functions: no walls.
struct CarryWalls {
  const void* context = nullptr;
  const std::uint8_t* beside = nullptr;  ///< by row
  void (*add)(const void* context, std::uint32_t row, CarryRow& sums) = nullptr;
  /// Returns the velocity (m/s) without its components towards adjacent walls.
  Vec3d (*along)(const void* context, std::uint32_t row, Vec3d velocity) = nullptr;
};

/// Fields of one step of carried densities. Columns are by row; null: not in use.
struct CarryStep {
  double dt = 0;         ///< s, last step, over which densities are advanced
  double ahead = 0;      ///< extrapolation factor of the correction: (end - mid-step) / (mid-step - previous
                         ///< mid-step)
  double diffusion = 0;  ///< 1, density diffusion
  double shifting = 0;   ///< speed of shifting over the speed of sound
  Vec3d weight{};        ///< m^2/s^2, h g
  EquationOfState eos = EquationOfState::Linear;
  double tensileLimit = 0;
  const LiquidMaterial* liquids = nullptr;
  const std::uint16_t* material = nullptr;
  const double* mass = nullptr;          ///< kg
  const double* restDensity = nullptr;   ///< kg/m^3; null: that of the material
  const std::uint8_t* steady = nullptr;  ///< not 0: the row does not change
  bool corrected = false, surfaces = false, solids = false;
  CarryWalls walls;
  // Results.
  double* compression = nullptr;      ///< 1, carried relative density minus 1
  double* dissipated = nullptr;       ///< J
  Sym3f* midCorrection = nullptr;     ///< 1, inverse of the moment minus 1
  Sym3f* correction = nullptr;        ///< 1, the same at the end of the step
  float* compressionRate = nullptr;   ///< 1/s, of the last step
  std::uint8_t* atSurface = nullptr;  ///< 1: at the free surface
  Vec3d* shiftingVelocity = nullptr;  ///< m/s
  Vec3f* relief = nullptr;            ///< N
  float* summed = nullptr;            ///< summed relative density, in steps that need it
  double* largestChange = nullptr;    ///< 1, largest change of a carried relative density in the step
  std::int64_t* crowded = nullptr;    ///< counts particles much denser than their carried density
};

/// Resets the carried density of a particle without liquid around it. Its compression energy is dissipated.
void resetCarriedDensity(const CarryStep& step, float* relativeDensity, std::uint32_t row);

}  // namespace thaw
