// SPDX-License-Identifier: Apache-2.0
// Parts of elastic solids that deform. A solid particle deforms if its rate of strain exceeds
// numerics.rigidify, or if the load on it changes. Softening or clamped particles, and particles near
// obstacles or other bodies, also count as deforming. Continuum::restTime is the time since a particle last
// deformed. Particles with a rest time of numerics.sleep_after become parts of rigid pieces, until they
// deform.
#pragma once
#include "core/rigid/rigidify/rigidify_view.hpp"

namespace thaw {

/// Returns true if a particle of an elastic solid shall be part of a rigid piece.
bool isToBeRigid(const Scene& scene, const Continuum& particles, std::size_t row);

/// Makes bodies eligible for rigid pieces at the first evaluation.
void restAtStart(const Scene& scene, Continuum& particles);

/// Makes particles near the solidus elastic together with softening particles.
void wakeSoftening(const RigidifyView& view);

/// Updates Continuum::restTime after a step of dt (s). Returns true if a particle of this rank must change
/// between elastic and rigid. Requires: positions and velocities of bond ends at the last evaluation.
bool findDeforming(const RigidifyView& view, double dt);

/// Returns true if all solids of this rank are rigid, and no two pieces are in adjacent cells. No step
/// limit of solids then applies. Requires: Continuum::piece of ghosts.
bool nothingDeforms(const RigidifyView& view);

}  // namespace thaw
