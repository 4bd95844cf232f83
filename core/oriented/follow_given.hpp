// While a surface is rebuilt between given points (3D interpolation), what holds its particles on the surface
// that the points suggest.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Finds the place (Oriented::home) and orientation (homeTurn) on that surface of all free rows of bodies
/// with given points. Where there is none, or it is more than `lost` spacings away, the row is marked as dead
/// (mass 0), and booked as left; returns how many of this rank's are.
std::int64_t findPlacesOnGiven(World& world, const StepTools& tools);

/// Is a row of a body with given points, that is not held, so far off that surface, or where there is none?
bool strayed(const World& world, const StepTools& tools, std::size_t row);

/// Adds to force and torque of all these rows a spring toward the plane there, along its normal alone, and
/// one that turns the normal.
void followGiven(const World& world, const StepTools& tools, std::vector<Vec3d>& force,
                 std::vector<Vec3d>& torque);

}  // namespace thaw
