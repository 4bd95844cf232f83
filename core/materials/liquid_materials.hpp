// SPDX-License-Identifier: Apache-2.0
// Liquid parameters of a material, computed once per run.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

struct LiquidMaterial {
  double stiffness = 0;       ///< Pa, rho0 c^2; for pure solids, that of the first liquid
  double soundSpeed = 0;      ///< m/s
  double artificial = 0;      ///< Pa s, alpha c h rho0 / 10: artificial viscosity of approaching pairs
  double pressureLead = 0;    ///< s, beta h / c: time by which the pressure leads the carried density
  double rootTension = 0;     ///< (N/m)^1/2
  double restVolume = 0;      ///< m^3/kg
  double surfaceDamping = 0;  ///< Pa s, least viscosity of approaching pairs at the free surface
};

/// Returns the artificial viscosity (Pa s) of a liquid at its free surface, given its own viscosity (Pa s).
/// Tension by curvature needs a minimum viscosity there.
inline double artificialAtSurface(const LiquidMaterial& l, double viscosity) {
  return std::max(l.artificial, l.surfaceDamping - viscosity);
}

/// Largest expected speed (m/s), see expectedFlow.
double expectedSpeed(const Scene& scene);

/// Returns true if the material is liquid from the start or can melt.
inline bool canBeLiquid(const Material& m) { return !m.canBeSolid() || m.melts() || m.liquidAtStart; }

/// Returns one entry per material. The automatic sound speed keeps compression below
/// Numerics::maxDensityError: c = v / sqrt(error), ten times v for the default of 1 % (M94). It is not below
/// the speed that surface tension causes at one spacing.
std::vector<LiquidMaterial> liquidMaterials(const Scene& scene);

/// Returns the reason for the sound speed, the end of the message "sound speed of ... m/s: ".
std::string soundSpeedReason(const Scene& scene, const Material& material);

/// Viscosity (Pa s) at a liquid fraction and temperature; logarithmic between the points of a table.
double viscosityAt(const Material& material, double liquidFraction, double temperature);

}  // namespace thaw
