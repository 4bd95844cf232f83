// SPDX-License-Identifier: Apache-2.0
#include "core/materials/liquid_materials.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/scene/expected_speeds.hpp"
#include "core/scene/temperature_table.hpp"

namespace thaw {

double expectedSpeed(const Scene& s) { return expectedFlow(s).speed; }

namespace {

/// Speed (m/s) that surface tension causes at one spacing.
double tensionSpeed(const Material& m, double spacing) {
  return std::sqrt(2 * m.surfaceTension / (m.density * spacing));
}

/// Returns the viscosity (Pa s) that damps capillary waves of a few spacings in tension by curvature: 0.1 rho
/// u h. The speed u is sqrt(gamma / (rho dx)), and at most a tenth of the speed of sound. 0 with other
/// forms of tension.
double surfaceDamping(const Scene& s, const Material& m, double soundSpeed) {
  if (s.numerics.tension != TensionForm::Curvature || !(m.surfaceTension > 0)) return 0;
  const double speed = std::sqrt(m.surfaceTension / (m.density * s.spacing));
  return 0.1 * m.density * std::min(speed, 0.1 * soundSpeed) * s.numerics.support * s.spacing;
}

constexpr double leastSpeed = 1e-3;  // m/s, expected speed if nothing moves

}  // namespace

std::vector<LiquidMaterial> liquidMaterials(const Scene& s) {
  std::vector<LiquidMaterial> all;
  const double v = expectedSpeed(s), h = s.numerics.support * s.spacing;
  for (const Material& m : s.materials) {
    LiquidMaterial l;
    l.soundSpeed = m.soundSpeed > 0 ? m.soundSpeed
                                    : std::max({v, tensionSpeed(m, s.spacing), leastSpeed}) /
                                          std::sqrt(s.numerics.maxDensityError);
    l.stiffness = m.density * l.soundSpeed * l.soundSpeed;
    l.artificial = m.artificialViscosity * l.soundSpeed * h * m.density / 10;
    l.pressureLead = m.bulkDamping * h / l.soundSpeed;
    l.rootTension = std::sqrt(m.surfaceTension);
    l.restVolume = 1 / m.density;
    all.push_back(l);
  }
  const auto liquid = std::find_if(s.materials.begin(), s.materials.end(), canBeLiquid);
  for (std::size_t k = 0; k < all.size() && liquid != s.materials.end(); k++)
    if (!canBeLiquid(s.materials[k])) {
      const LiquidMaterial& around = all[static_cast<std::size_t>(liquid - s.materials.begin())];
      all[k].stiffness = around.stiffness;
      all[k].soundSpeed = around.soundSpeed;
    }
  for (std::size_t k = 0; k < all.size(); k++)
    all[k].surfaceDamping = surfaceDamping(s, s.materials[k], all[k].soundSpeed);
  return all;
}

std::string soundSpeedReason(const Scene& s, const Material& m) {
  if (m.soundSpeed > 0) return "given by the material's `sound_speed`";
  const FlowSpeed flow = expectedFlow(s);
  const double tension = tensionSpeed(m, s.spacing), speed = std::max({flow.speed, tension, leastSpeed});
  const std::string why = speed == flow.speed ? flow.why
                          : speed == tension  ? "from surface tension at one spacing"
                                              : "minimum value; no motion is expected";
  char times[80];
  std::snprintf(times, sizeof times, "%.3g times %.3g m/s, ", 1 / std::sqrt(s.numerics.maxDensityError),
                speed);
  return times + why;
}

double viscosityAt(const Material& m, double liquidFraction, double temperature) {
  if (m.viscosityTable.empty()) return m.viscosity.at(liquidFraction);
  return valueAt(m.viscosityTable, temperature, Interpolation::Logarithmic);
}

}  // namespace thaw
