// What the loops over particles need of a material, worked out once a run.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

struct LiquidMaterial {
  double stiffness = 0;    ///< Pa, rho0 c^2; for pure solids, that of the first liquid
  double soundSpeed = 0;   ///< m/s
  double artificial = 0;   ///< Pa s, alpha c h rho0 / 10: artificial viscosity as a viscosity of approaching
                           ///< pairs
  double rootTension = 0;  ///< (N/m)^1/2
  double restVolume = 0;   ///< m^3/kg
};

/// Largest speed (m/s) to expect (expectedFlow).
double expectedSpeed(const Scene& scene);

/// Is it liquid from the start, or does it melt?
inline bool canBeLiquid(const Material& m) { return !m.canBeSolid() || m.melts() || m.liquidAtStart; }

/// One for each material. The automatic sound speed keeps compression below Numerics::maxDensityError: c = v
/// / sqrt(error), at least ten times v for the default of 1 % (Monaghan 1994); and not less than what surface
/// tension needs at one spacing.
std::vector<LiquidMaterial> liquidMaterials(const Scene& scene);

/// The rest of the sentence "sound speed of ... m/s: ", on what sets it.
std::string soundSpeedReason(const Scene& scene, const Material& material);

/// Viscosity (Pa s) at a liquid fraction and temperature; logarithmic between the points of a table.
double viscosityAt(const Material& material, double liquidFraction, double temperature);

}  // namespace thaw
