// SPDX-License-Identifier: Apache-2.0
// External forces on oriented particles other than gravity: acceleration and pressure of the body, and its
// fields (OrientedField).
#pragma once
#include "core/halo/halo.hpp"
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

struct FieldForce {
  Vec3d force{};     ///< N
  double slope = 0;  ///< 1/s^2, upper bound of the force gradient over mass
};

/// Returns the force on an owned row at OrientedWork::time. Within a step of length OrientedWork::over, it is
/// the mean over the step, so impulses do not depend on the step size. Runge-Kutta samples a linear factor at
/// its stages, which gives the same mean. The attraction at distance r is a u (1 - u^2)^2 / 0.2862 with u =
/// r/R. It is conservative, with the energy per mass -a R (1 - u^2)^3 / 1.717.
FieldForce fieldForce(const OrientedView& view, std::size_t row);

/// Replaces changing field forces at the start of a step of dt (s) by their means over the step.
void averageFields(const OrientedView& view, double dt);

/// Appends to OrientedWork::unusedFields the fields that begin in (after, upTo] and act on no particle.
/// Collective, if such fields exist.
void recordUnusedFields(const OrientedView& view, Reducer& all, double after, double upTo);

/// Returns the regions of all fields, null for an unbounded one. Throws ShapeError for a mesh that cannot be
/// read.
std::vector<std::vector<std::shared_ptr<const SignedDistance>>> fieldRegions(const Scene& scene,
                                                                             const MeshLoader& load);

}  // namespace thaw
