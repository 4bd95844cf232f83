// SPDX-License-Identifier: Apache-2.0
// Heat of particles: sources, losses at free surfaces, enthalpy update, melting and freezing. Conduction
// between particles, equal and opposite in each pair: `conducted` in core/fluid/terms/term.hpp.
#pragma once
#include <cstdint>
#include <vector>

#include "core/heat/heat_view.hpp"
#include "core/ledger/counters.hpp"

namespace thaw {

/// Sets temperature, liquid fraction, phase and density at rest of rows [begin, end) from their enthalpy. In
/// the paper's model it starts from the temperature. For set-up and emitted particles. The phase is liquid if
/// the fraction is 1 or the material cannot be solid, else solid.
void setPhase(const Scene& scene, const Modules& modules, Continuum& particles, std::size_t begin,
              std::size_t end);

/// Adds heat sources and losses at free surfaces (convection, Stefan-Boltzmann radiation) to heatFlow; area =
/// spacing^2 * Continuum::exposedArea. The heat gained over dt (s) is recorded in Ledger::heatIn.
/// Rows with skipped sums (WallContext::steady) are left out.
void addOuterHeat(const HeatView& view, double dt, const std::vector<std::uint8_t>* steady = nullptr);

/// Adds the heat of the scene's thermostats for the step of length dt (s) that begins now, and records it in
/// Ledger::heatIn.
void addThermostats(const HeatView& view, double dt);

/// H += dt heatFlow / m, then temperature and liquid fraction. In the paper's model T += dt * (heatFlow / (m
/// c)), with K05's diffusivity as conductivity (Material::paperDiffusivity, by conductivityOf).
void updateHeat(const HeatView& view, double dt);

/// Changes the phase of particles: a solid melts when its fraction reaches 1 (1 - hysteresis), a liquid
/// freezes when it falls to hysteresis (0 without). Sets phase and justFrozen, and counts changes. Only the
/// particle's own state matters.
struct PhaseChanges {
  bool melted = false, frozen = false;
};
PhaseChanges changePhase(const Scene& scene, Continuum& particles, Counters& counters);

}  // namespace thaw
