// SPDX-License-Identifier: Apache-2.0
// Initial velocities and temperatures that depend on position: spin, gradients, expressions.
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/sampling/sampling.hpp"
#include "core/halo/halo.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

using Shapes = std::vector<std::shared_ptr<const SignedDistance>>;

/// Middle of the bounding box (m).
Vec3d middleOf(const SignedDistance& shape);

/// Returns the lattice on which a body's particles are sampled: ids are numbers of its points.
SampleLattice bodyLattice(const Scene& scene, const Body& body, const SignedDistance& shape);

/// Initial velocity (m/s) and temperature (K) at x (m). centre: of the body's bounding box.
Vec3d startVelocity(const Body& body, const Vec3d& centre, const Vec3d& x);
double startTemperature(const Body& body, const Vec3d& centre, const Vec3d& x);

/// Sets velocity, temperature and phase of this rank's particles of bodies with fields, from their current
/// positions. Positions across a periodic side count unwrapped, as in the body. relaxed: only bodies of
/// relaxed packing, including those with just a spin or temperature gradient. Throws ShapeError on all ranks
/// if a field has an invalid value at a particle (core/scene/field_values.hpp). Collective.
void assignStartFields(World& world, const Shapes& shapes, Reducer& all, bool relaxed);

/// Gives particles the mass of a cell of the lattice at their density at rest, where phases differ in
/// density. Requires: setPhase.
void setStartMasses(const Scene& scene, Continuum& particles);

}  // namespace thaw
