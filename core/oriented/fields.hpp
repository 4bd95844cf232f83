// What acts on oriented particles from outside beside gravity: push and pressure of the body, and its fields
// (OrientedField).
#pragma once
#include "core/halo/halo.hpp"
#include "core/oriented/oriented_work.hpp"
#include "core/world.hpp"

namespace thaw {

struct FieldForce {
  Vec3d force{};     ///< N
  double slope = 0;  ///< 1/s^2, bound of its change with the place, over the mass
};

/// On an owned row, at OrientedWork::time; within a step, where OrientedWork::over is its length, the mean
/// over that step: what a field gives is then the same by whatever steps. (Runge-Kutta takes a field that
/// changes evenly over its step as it is at its stages: of that its sum is the mean.) A pull toward a point
/// at the distance r is a u (1 - u^2)^2 / 0.2862, u = r/R: the slope of the energy per mass -a R (1 - u^2)^3
/// / 1.717, so that what it gives it takes back.
FieldForce fieldForce(const World& world, const OrientedWork& work, std::size_t row);

/// Begins a step of dt (s): where fields change within it, forces that were found at its beginning get the
/// means over it.
void takeMeanFields(World& world, OrientedWork& work, double dt);

/// Notes in OrientedWork::idleFields the fields that begin after a time and up to another one, and then meet
/// no particle. Collective, where there are any.
void noteIdleFields(const World& world, Reducer& all, OrientedWork& work, double after, double upTo);

/// Where the fields of all bodies act. Throws ShapeError for a mesh that cannot be read.
std::vector<std::vector<std::shared_ptr<const SignedDistance>>> fieldRegions(const Scene& scene,
                                                                             const MeshLoader& load);

}  // namespace thaw
