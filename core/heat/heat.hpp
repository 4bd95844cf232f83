// SPDX-License-Identifier: Apache-2.0
// Heat of particles: sources, losses at free surfaces, enthalpy update, melting and freezing. Conduction
// between particles is `conducted` in core/fluid/terms/term.hpp.
#pragma once
#include <cstdint>
#include <vector>

#include "core/heat/heat_view.hpp"
#include "core/ledger/counters.hpp"

namespace thaw {

/// Sets temperature, liquid fraction, phase and rest density of rows [begin, end) from their enthalpy, or
/// from the temperature in the paper's model. It is for set-up and emitted particles. The phase is liquid if
/// the fraction is 1 or the material cannot be solid, else solid.
void setPhase(const Scene& scene, const Modules& modules, Continuum& particles, std::size_t begin,
              std::size_t end);

/// Adds heat sources and losses at free surfaces (convection, Stefan-Boltzmann radiation) to heatFlow; area =
/// spacing^2 * Continuum::exposedArea. Records the heat gained over dt (s) in Ledger::heatIn.
/// Skips rows with skipped sums (WallContext::steady).
void addOuterHeat(const HeatView& view, double dt, const std::vector<std::uint8_t>* steady = nullptr);

/// Adds the heat of the scene's thermostats for the step of dt (s) that begins now. Records it in
/// Ledger::heatIn.
void addThermostats(const HeatView& view, double dt);

/// Updates enthalpy, H += dt heatFlow / m, then temperature and liquid fraction. dt: s. In the paper's model,
/// T += dt * (heatFlow / (m c)). There, conductivityOf returns K05's diffusivity
/// (Material::paperDiffusivity).
void updateHeat(const HeatView& view, double dt);

/// Changes the phase of particles. A solid melts when its liquid fraction reaches 1 - hysteresis. A liquid
/// freezes when its liquid fraction falls to hysteresis. Sets phase and justFrozen, and counts changes. Only
/// the particle's own state matters.
struct PhaseChanges {
  bool melted = false, frozen = false;
};
PhaseChanges changePhase(const Scene& scene, Continuum& particles, Counters& counters);

}  // namespace thaw
