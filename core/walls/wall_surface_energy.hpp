// SPDX-License-Identifier: Apache-2.0
// Surface energy of liquids at walls (core/fluid/laws/surface_energy.hpp).
//
// A wall counts as liquid, which gives a contact angle of 90 degrees. At an angle theta a particle has
//   E = E(with walls) - cos(theta) (E(without) - E(with walls)),
// where `without` excludes the walls of that angle. The difference is the energy of the surface that the wall
// covers, so the covered area costs -gamma cos(theta), as in Young's law. Forces are the derivatives, so
// energy is conserved.
#pragma once
#include <span>

#include "core/fluid/laws/surface_energy.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Cosine of the contact angle: the wall's angle, else that of the material. 0 at 90 degrees.
double wettingOf(const Material& material, const Obstacle& wall);
/// Returns the cosine of the contact angle for the particle and the wall of a contact.
double wettingAt(const WallView& world, const WallContact& contact);

/// Updates Continuum::surfaceTension of owned particles. Requires: Modules::tensionTable.
void updateSurfaceTension(const WallView& world);

/// Surface tension (N/m) of the liquid part of a particle.
double tensionOfParticle(const WallView& world, std::size_t row);

struct SurfaceContext {
  WallView world;
  const SurfaceMeasure& measure;
};

/// A particle with its surroundings.
struct SurfaceParticle {
  std::uint32_t row;
  double tension;                         ///< N/m
  SurfaceKernelValue sums;                ///< over neighbours and walls
  std::span<const WallContact> contacts;  ///< with walls; empty if all angles are 90 degrees
};

/// Surface energy per volume (J/m^3) of a particle.
double surfaceEnergyOf(const SurfaceContext& context, const SurfaceParticle& particle);

/// Returns the surface energy (J) of a particle with these contacts. Requires: surfaceGradient and
/// surfaceColour without walls.
double surfaceEnergyWith(const SurfaceContext& context, std::uint32_t row,
                         std::span<const WallContact> contacts);

/// Adds the walls to surfaceGradient and surfaceColour of owned particles, computes surfaceEnergyByGradient
/// and surfaceEnergyByColour, and adds E to Continuum::interaction. With contact angles it also adds the
/// forces of walls, their work and impulse, which addWallForces then leaves out.
void findSurfaceEnergy(const WallContext& context, const SurfaceMeasure& measure,
                       const WallContacts& contacts);

/// Force (N) of the wall along the contact normal: the gradient of the particle's own surface energy.
/// Requires: no contact angles.
double surfaceForceOfWall(const Scene& scene, const CellGrid& grid, const Continuum& particles,
                          const WallContact& contact);

/// Records the change of surface energy due to the temperature dependence of the tension. Call it after
/// temperatures change and before positions change. Requires: Modules::tensionTable.
void recordTensionChange(const SurfaceContext& context, const WallContacts& contacts);

}  // namespace thaw
