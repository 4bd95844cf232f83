// SPDX-License-Identifier: Apache-2.0
// Enthalpy, temperature and liquid fraction of a material. The enthalpy H is per mass. It is zero at the
// solidus, or at 0 K for materials that do not melt:
//   H < 0            solid    T = solidus + H / c_solid
//   0 <= H <= band   melting  T and the fraction f rise linearly with H,
//                             T over [solidus, liquidus], f over [0, 1]
//   above            liquid   T = liquidus + (H - band) / c_liquid
// band = latent heat + mean heat capacity times (liquidus - solidus). The state variable is the enthalpy,
// since a step cannot skip the latent heat then. With an apparent heat capacity it can (docs/theory/heat.md).
#pragma once
#include <algorithm>

#include "core/scene/scene.hpp"

namespace thaw {

struct Thermal {
  double temperature, liquid;
};  ///< K, 1

/// Enthalpy difference between solidus and liquidus (J/kg).
inline double meltingBand(const Material& m) {
  return m.latentHeat + 0.5 * (m.heatCapacity.solid + m.heatCapacity.liquid) * (m.liquidus - m.solidus);
}

/// Liquid fraction of a material that does not melt.
inline double restFraction(const Material& m) { return m.canBeSolid() && !m.liquidAtStart ? 0 : 1; }

inline Thermal thermalOf(const Material& m, double H) {
  if (!m.melts()) return {H / m.heatCapacity.at(restFraction(m)), restFraction(m)};
  if (H < 0) return {m.solidus + H / m.heatCapacity.solid, 0};
  const double band = meltingBand(m);
  if (H <= band && band > 0) return {m.solidus + (m.liquidus - m.solidus) * (H / band), H / band};
  return {m.liquidus + (H - band) / m.heatCapacity.liquid, 1};
}

/// Enthalpy (J/kg) at a temperature T (K); the inverse of thermalOf. If solidus == liquidus,
/// fractionAtMelting in [0, 1] gives the liquid fraction at that temperature.
inline double enthalpyOf(const Material& m, double T, double fractionAtMelting = 0) {
  if (!m.melts()) return T * m.heatCapacity.at(restFraction(m));
  if (T < m.solidus) return (T - m.solidus) * m.heatCapacity.solid;
  if (T > m.liquidus) return meltingBand(m) + (T - m.liquidus) * m.heatCapacity.liquid;
  const double width = m.liquidus - m.solidus;
  return meltingBand(m) * (width > 0 ? (T - m.solidus) / width : std::clamp(fractionAtMelting, 0.0, 1.0));
}

/// Blend parameter of K05's plain model, in which the temperature (K) is the state variable.
inline double paperFraction(const Material& m, double T) {
  if (!m.melts()) return restFraction(m);
  const double width = m.liquidus - m.solidus;
  return width > 0 ? std::clamp((T - m.solidus) / width, 0.0, 1.0) : T >= m.solidus ? 1 : 0;
}

/// Enthalpy (J/kg) in the energy budget at a temperature (K). In K05's plain model it is c T, without latent
/// heat.
inline double ledgerEnthalpy(HeatModel model, const Material& m, double T, double fractionAtMelting = 0) {
  return model == HeatModel::Paper ? m.heatCapacity.solid * T : enthalpyOf(m, T, fractionAtMelting);
}

/// Heat capacity at a liquid fraction (J/(kg K)); constant in K05's plain model.
inline double heatCapacityOf(HeatModel model, const Material& m, double liquidFraction) {
  return model == HeatModel::Paper ? m.heatCapacity.solid : m.heatCapacity.at(liquidFraction);
}

/// Conductivity at a liquid fraction (W/(m K)). K05's plain model has dT/dt = k_heat lap T, so k_heat is the
/// diffusivity.
inline double conductivityOf(HeatModel model, const Material& m, double liquidFraction) {
  return model == HeatModel::Paper ? m.paperDiffusivity * m.density * m.heatCapacity.solid
                                   : m.conductivity.at(liquidFraction);
}

}  // namespace thaw
