// SPDX-License-Identifier: Apache-2.0
// Direction and ends of the sharp edge of a round surface element, packed into its radius.
#pragma once
#include "core/math/quat.hpp"
#include "core/rigid/contact/sharp_edge.hpp"
#include "core/rigid/contact/surface_element.hpp"

namespace thaw {

/// Returns the round element of a particle next to a sharp edge or corner. offset: m, distance of the
/// particle from the nearest face. spacing: m. Directions are accurate to 5e-5 rad, ends to 0.05 spacings.
SurfaceElement elementOfEdge(double offset, const SharpEdge& edge, double spacing);

/// Returns the sharp edge or corner of a round element; none if it is round in all directions.
SharpEdge edgeOf(const SurfaceElement& element, double spacing);

/// Returns the rotated element. Its directions are rounded again.
SurfaceElement turned(const SurfaceElement& element, const Quat& rotation);

}  // namespace thaw
