// SPDX-License-Identifier: Apache-2.0
// Particles that move together as bodies, for solvers of velocities.
#pragma once
#include <span>

#include "core/math/vec3.hpp"

namespace thaw {

class JointMotion {
 public:
  virtual ~JointMotion() = default;

  /// Replaces the velocity changes (m/s) of free particles due to impulses by those of the bodies to which
  /// the particles belong, in owned rows. Other rows do not change. The map is a projection. Except for the
  /// particles' own moments of inertia, it is orthogonal in the norm of kinetic energy. Collective.
  virtual void join(std::span<Vec3d> changes) = 0;

  /// Adds the impulses of the last call of join to the bodies and sets the velocities of their particles. The
  /// loss of kinetic energy is recorded as dissipation.
  virtual void kick() = 0;

  /// Stores the impulses of the last call of join for the start of the next step.
  virtual void keep() = 0;
};

}  // namespace thaw
