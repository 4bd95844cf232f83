// Heat of particles: sources, loss from free surfaces, the update of enthalpy, and what melts or freezes.
#pragma once
#include <cstdint>
#include <vector>

#include "core/world.hpp"

namespace thaw {

/// Sets temperature, liquid fraction and phase of rows [begin, end) from their enthalpy (from the temperature in the paper's model),
/// at set-up and for emitted particles: liquid where the fraction is 1 (or the material cannot be solid), else solid.
void settlePhase(const Scene& scene, const Modules& modules, Continuum& particles, std::size_t begin, std::size_t end);

/// Adds sources and the loss of free surfaces (convection, radiation by Stefan-Boltzmann; area = exposure * spacing^2) to heatFlow.
/// What comes in over dt (s) is booked in Ledger::heatIn.
void addOuterHeat(World& world, double dt);

/// H += dt heatFlow / m, then temperature and liquid fraction. In the paper's model T += dt * (heatFlow / (m c)) with K05's
/// diffusivity in the place of conductivity (Material::paperDiffusivity, set in the records).
void updateHeat(World& world, double dt);

/// Rows whose phase changes now, ascending: a solid melts when its fraction reaches 1 (1 - hysteresis), a liquid freezes when it
/// falls to hysteresis (0 without). Sets phase and justFrozen; counts. Nothing but the particle's own state decides.
struct PhaseChanges { bool melted = false, frozen = false; };
PhaseChanges changePhase(World& world);

}  // namespace thaw
