// Velocities and temperatures of the start that vary with position: spin, gradients, expressions.
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/sampling.hpp"
#include "core/halo/halo.hpp"
#include "core/world.hpp"

namespace thaw {

using Shapes = std::vector<std::shared_ptr<const SignedDistance>>;

/// m, of the bounding box.
Vec3d middleOf(const SignedDistance& shape);

/// The lattice that a body's particles are sampled on: ids are numbers of its points.
SampleLattice bodyLattice(const Scene& scene, const Body& body, const SignedDistance& shape);

/// Velocity (m/s) and temperature (K) at the start of what is at x (m). centre: of the body's bounding box.
Vec3d startVelocity(const Body& body, const Vec3d& centre, const Vec3d& x);
double startTemperature(const Body& body, const Vec3d& centre, const Vec3d& x);

/// Sets velocity, temperature and phase of this rank's particles of bodies with fields, by their positions
/// now. Positions across a periodic side count where the body has them. relaxed: only bodies of relaxed
/// packing, also those that only spin or have a temperature gradient.
/// Throws ShapeError on all ranks where a field has a value at a particle that it may not have
/// (core/scene/field_values.hpp). Collective.
void assignStartFields(World& world, const Shapes& shapes, Reducer& all, bool relaxed);

}  // namespace thaw
