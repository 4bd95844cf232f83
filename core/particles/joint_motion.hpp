// SPDX-License-Identifier: Apache-2.0
// Particles that cannot move on their own, for solvers of velocities.
#pragma once
#include <span>

#include "core/math/vec3.hpp"

namespace thaw {

class JointMotion {
 public:
  virtual ~JointMotion() = default;

  /// Replaces the velocity changes (m/s) that impulses give to free particles by those of the bodies that
  /// they belong to, in owned rows. Other rows stay as they are. The map is a projection, orthogonal in the
  /// norm of kinetic energy but for the particles' own moments of inertia. Collective.
  virtual void join(std::span<Vec3d> changes) = 0;

  /// Adds the impulses of the last call of join to the bodies and sets the velocities of their particles; the
  /// loss of kinetic energy is recorded as dissipated.
  virtual void kick() = 0;

  /// Keeps the impulses of the last call of join for the start of the next step.
  virtual void keep() = 0;
};

}  // namespace thaw
