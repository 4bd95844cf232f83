// SPDX-License-Identifier: Apache-2.0
// Size of a body for messages: a mesh file in units other than metres is the usual cause of a wrong size.
#pragma once
#include <string>

#include "core/geometry/basic/signed_distance.hpp"

namespace thaw {

/// Returns "; its size is 250 x 180 x 300 m", and a remedy for a mesh file. The remedy is the file's units
/// ("place = { scale = 0.001 }, if its file is in millimetres"), removal of too small a scale, or
/// place.height.
std::string sizeHint(const Scene& scene, const Shape& shape, const Bounds& bounds);

/// Returns "0.0041 m".
std::string lengthText(double metres);

/// Returns the axes along which a body is narrower than the spacing, as "0.004 m along z". Returns "" if
/// there are none. A body's single layer of particles is thicker than the body there.
std::string narrowAxes(const Bounds& bounds, double spacing);

}  // namespace thaw
