// SPDX-License-Identifier: Apache-2.0
// Initial velocities and temperatures that depend on position: spin, gradients, expressions.
#pragma once
#include <span>
#include <vector>

#include "core/domain/body_lattices.hpp"
#include "core/halo/halo.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Middle of the bounding box (m).
Vec3d middleOf(const SignedDistance& shape);

/// Initial velocity (m/s) and temperature (K) at x (m). centre: of the body's bounding box.
Vec3d startVelocity(const Body& body, const Vec3d& centre, const Vec3d& x);
double startTemperature(const Body& body, const Vec3d& centre, const Vec3d& x);

/// Sets velocity, temperature and phase of this rank's particles of bodies with fields, from their current
/// positions. Positions across a periodic side are unwrapped first, as in the body. relaxed: only bodies with
/// relaxed packing, including bodies with only a spin or temperature gradient. Throws ShapeError on all ranks
/// if a field has an invalid value at a particle (core/scene/field_values.hpp). Collective.
void assignStartFields(World& world, const Shapes& shapes, Reducer& all, bool relaxed);

/// If phases differ in density, sets the mass of particles to that of a cell of their body's lattice at their
/// density at rest. Requires: setPhase.
void setStartMasses(std::span<const SampleLattice> lattices, Continuum& particles);

}  // namespace thaw
