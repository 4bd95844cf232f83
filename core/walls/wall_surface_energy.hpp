// SPDX-License-Identifier: Apache-2.0
// Surface energy of liquids at walls (core/fluid/laws/surface_energy.hpp).
#pragma once
#include "core/fluid/laws/surface_energy.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Adds the walls to surfaceGradient and surfaceColour of owned particles, computes surfaceEnergyByGradient
/// and surfaceEnergyByColour, and adds E to Continuum::interaction.
void findSurfaceEnergy(const WallContext& context, const SurfaceMeasure& measure,
                       const WallContacts& contacts);

/// Force (N) of the wall along the contact normal: the gradient of the particle's own surface energy.
double surfaceForceOfWall(const Scene& scene, const CellGrid& grid, const Continuum& particles,
                          const WallContact& contact);

}  // namespace thaw
