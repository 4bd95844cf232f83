// SPDX-License-Identifier: Apache-2.0
// Buoyancy of liquids whose density depends on the temperature (B03): only their
// weight changes, not their volume at rest. docs/theory/buoyancy.md has the equations.
#pragma once
#include "core/scene/scene.hpp"

namespace thaw {

/// Returns true if the density of the liquid depends on its temperature.
inline bool expands(const Material& m) { return m.expansion != 0 || !m.densityTable.empty(); }

/// Returns true if an expanding material is in use and the scene has gravity.
bool hasBuoyancy(const Scene& scene);

/// Returns the temperature (K) at which the liquid has Material::density.
double referenceTemperature(const Domain& domain, const Material& material);

/// Returns 1 - rho(T) / rho0 of the liquid at temperature T (K): beta (T - T0), or by its table of densities.
double densityDeficit(const Domain& domain, const Material& material, double T);

/// Smallest and largest value; low > high: none.
struct ValueRange {
  double low = never, high = -never;
  void see(double x) { low = x < low ? x : low, high = x > high ? x : high; }
  bool empty() const { return low > high; }
  double width() const { return empty() ? 0 : high - low; }
};

/// Returns the range of temperatures (K) of bodies, emitters, obstacles, thermostats, and of the ambient if a
/// material exchanges heat with it. Temperature fields of bodies count from set-up on.
ValueRange temperatureRange(const Scene& scene);

/// Returns the range of deficits of density of the liquids in use, over the range of temperatures.
ValueRange deficitRange(const Scene& scene);

/// Returns the deficit of density that has no buoyancy. It is 0 where the weight acts. Where the hydrostatic
/// part is subtracted and no solid is present, it is the middle of deficitRange: buoyancy then causes the
/// least pressure.
double neutralDeficit(const Scene& scene);

/// Speed (m/s) of free convection through the height H of the domain: sqrt(g (deficit range) H) / 2. 0
/// without buoyancy. Its square is the largest pressure of the differences of density, over the density.
/// Flows in cavities reach half of it (DVD83).
double buoyantSpeed(const Scene& scene);

/// Returns true if liquid of one density fills the closed domain. It then has no free surface, and
/// hydrostatic pressure carries its weight. Bodies are unrotated boxes of liquid with the volume of the
/// domain. Each side of the domain is periodic, a wall, or covered by a fixed plane. The scene has nothing
/// else.
bool liquidFillsClosedDomain(const Scene& scene);

}  // namespace thaw
