// Heat of particles: sources, loss from free surfaces, the update of enthalpy, and what melts or freezes.
#pragma once
#include <cstdint>
#include <vector>

#include "core/world.hpp"

namespace thaw {

/// Sets temperature, liquid fraction and phase of rows [begin, end) from their enthalpy (from the temperature
/// in the paper's model), at set-up and for emitted particles: liquid where the fraction is 1 (or the
/// material cannot be solid), else solid.
void settlePhase(const Scene& scene, const Modules& modules, Continuum& particles, std::size_t begin,
                 std::size_t end);

/// Adds sources and the loss of free surfaces (convection, radiation by Stefan-Boltzmann) to heatFlow; area =
/// spacing^2 * exposedArea. What comes in over dt (s) is booked in Ledger::heatIn. Not for rows that are deep
/// (WallContext::deep).
void addOuterHeat(World& world, double dt, const std::vector<std::uint8_t>* deep = nullptr);

/// Adds what the scene's temperings bring or take in the step of length dt (s) that begins now; booked in
/// Ledger::heatIn.
void addTempering(World& world, double dt);

/// Area of a particle's free surface in units of spacing^2, from Continuum::exposure: 1 for particles of a
/// flat lattice surface, 0 for exposures below half of that, which disorder brings about in the middle of a
/// liquid (0.4 for jitter of 0.15 spacings at h = 2).
double exposedArea(double exposure, double surfaceExposure);

/// Exposure of the outermost particles of a flat lattice surface.
double latticeSurfaceExposure(const Numerics& numerics);

/// H += dt heatFlow / m, then temperature and liquid fraction. In the paper's model T += dt * (heatFlow / (m
/// c)) with K05's diffusivity in the place of conductivity (Material::paperDiffusivity, by conductivityOf).
void updateHeat(World& world, double dt);

/// Rows whose phase changes now, ascending: a solid melts when its fraction reaches 1 (1 - hysteresis), a
/// liquid freezes when it falls to hysteresis (0 without). Sets phase and justFrozen; counts. Nothing but the
/// particle's own state decides.
struct PhaseChanges {
  bool melted = false, frozen = false;
};
PhaseChanges changePhase(World& world);

}  // namespace thaw
