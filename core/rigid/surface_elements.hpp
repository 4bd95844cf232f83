// SPDX-License-Identifier: Apache-2.0
// Surface elements of the particles of pieces, for contacts.
#pragma once
#include <memory>
#include <span>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Sets the elements of particles of rigid bodies from the shapes of the bodies, along the axes of the
/// domain. bodyShapes: one for each body of the scene. Requires: Continuum::piece.
void elementsOfShapes(const Scene& scene, std::span<const std::shared_ptr<const SignedDistance>> bodyShapes,
                      Continuum& particles);

/// Rotates the surface element of a particle. The rotation is from a former piece's body frame to the
/// domain's axes, or from these to the new piece's body frame.
void turnElement(Continuum& particles, std::size_t row, const Quat& rotation);

/// Sets the elements of owned particles near which particles of their piece appeared or vanished. The
/// elements follow from the surrounding particles, along the axes of the domain. Requires: Continuum::piece
/// and setLabel of the former and new pieces, with ghosts.
void renewElements(const RigidView& view);

}  // namespace thaw
