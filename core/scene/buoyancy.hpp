// SPDX-License-Identifier: Apache-2.0
// Buoyancy of liquids whose density depends on the temperature (B03): the weight changes, but not the volume
// at rest. docs/theory/buoyancy.md has the equations.
#pragma once
#include "core/scene/scene.hpp"

namespace thaw {

/// Returns true if the density of the liquid depends on its temperature.
inline bool expands(const Material& m) { return m.expansion != 0 || !m.densityTable.empty(); }

/// Returns true if an expanding material is in use and the scene has gravity.
bool hasBuoyancy(const Scene& scene);

/// Returns the temperature (K) at which the liquid has Material::density.
double referenceTemperature(const Domain& domain, const Material& material);

/// Returns the density deficit 1 - rho(T) / rho0 (1) of the liquid at temperature T (K): beta (T - T0), or
/// from its density table.
double densityDeficit(const Domain& domain, const Material& material, double T);

/// Smallest and largest value. low > high: no value.
struct ValueRange {
  double low = never, high = -never;
  void see(double x) { low = x < low ? x : low, high = x > high ? x : high; }
  bool empty() const { return low > high; }
  double width() const { return empty() ? 0 : high - low; }
};

/// Returns the range of temperatures (K) of bodies, emitters, obstacles and thermostats. It includes the
/// ambient temperature if a material exchanges heat with the ambient. Temperature fields of bodies are
/// included only after set-up.
ValueRange temperatureRange(const Scene& scene);

/// Returns the range of density deficits (1) of the liquids in use, over the range of temperatures.
ValueRange deficitRange(const Scene& scene);

/// Returns the density deficit (1) without buoyancy. If the weight acts, it is 0. If the hydrostatic part is
/// subtracted and no solid is present, it is the middle of deficitRange, for which buoyancy causes the
/// smallest pressure.
double neutralDeficit(const Scene& scene);

/// Returns the speed (m/s) of free convection through the height H of the domain: sqrt(g (deficit range) H) /
/// 2. It is 0 without buoyancy. The squared speed times the density is the largest pressure due to density
/// differences. Flows in cavities reach half of this speed (DVD83).
double buoyantSpeed(const Scene& scene);

/// Returns true if liquid of one density fills the closed domain. It then has no free surface, and
/// hydrostatic pressure carries its weight. The bodies are unrotated boxes of liquid with the volume of the
/// domain. Each side of the domain is periodic, a wall, or covered by a fixed plane. The scene contains
/// nothing else.
bool liquidFillsClosedDomain(const Scene& scene);

}  // namespace thaw
