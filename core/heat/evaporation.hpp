// SPDX-License-Identifier: Apache-2.0
// Evaporation of liquids at free surfaces (docs/theory/evaporation.md): a sink of mass and latent heat.
// Particles lose mass, and are removed when little mass remains.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/fluid/pair_sums/records.hpp"
#include "core/heat/heat_view.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Fraction (1) of the mass of a full particle, density times spacing^3. Lighter particles are removed.
inline constexpr double leastVapourFraction = 0.02;

struct EvaporationView {
  HeatView heat;
  RecordContext records;
  const NeighbourLists& neighbours;
  const WallContacts& contacts;
  const WallTables& tables;
  double inverseLatticeSum;  ///< factor that turns sums over V W into relative densities
  double selfExcess;         ///< PairSums::selfExcess
};

/// Returns the mean rate of evaporation (kg/(m^2 s)) over dt (s), while it cools the particle from T (K):
/// dT/dt = -cooling r(T). The solution is exact for the table, so no step crosses a temperature at which the
/// rate is 0.
double meanRate(const TemperatureTable& rate, double T, double cooling, double dt);

/// Sets Continuum::volumeGradient of liquids that evaporate: twice the spacing times the gradient of the
/// volume fraction of neighbours and walls. Requires: Continuum::freeSurfaceIndicator, of pairs alone;
/// positions and masses of ghosts.
void findExposure(const EvaporationView& view);

/// Sets Continuum::vapour, the mass that evaporates over the step of dt (s) that ends now, and
/// Continuum::vapourEnergy.
/// Requires: volumeGradient, relativeDensity and derivatives of the surface energy of ghosts. pairEnergy: J,
/// compression and tension of owned rows.
/// Ensures: the latent heat is subtracted from heatFlow, and recorded in Ledger::heatIn and vapourHeat.
/// The area of a particle is its volume times the component of the gradient along the surface's normal. It is
/// exact for a flat surface in any arrangement of particles, since gradients of pairs cancel in the sum.
void findVapour(const EvaporationView& view, const WallContext& walls, std::span<const double> pairEnergy,
                double dt);

/// Removes Continuum::vapour from the particles. Returns the rows with too little remaining mass, ascending.
/// dt: s, the step that ends now. Requires: velocities at the middle of that step. The caller removes the
/// returned rows and records them.
/// Ensures: Ledger::left and evaporated include the mass, momentum and energy of the vapour. A particle that
/// froze keeps its mass, since its volume as a solid is known.
std::vector<std::uint32_t> removeVapour(const HeatView& view, const RecordContext& records, double dt);

}  // namespace thaw
