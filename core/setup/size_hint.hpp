// How large a body is, for messages: a mesh whose file is in other units than metres is the usual reason why
// it does not fit.
#pragma once
#include <string>

#include "core/geometry/signed_distance.hpp"

namespace thaw {

/// "; it is 250 x 180 x 300 m large", and of a mesh in a file what would make it fit: its units ("place = {
/// scale = 0.001 }, if its file is in millimetres"), no scale where there is one that makes it smaller than
/// the spacing, or place.height.
std::string sizeHint(const Scene& scene, const Shape& shape, const Bounds& bounds);

/// "0.0041 m"
std::string lengthText(double metres);

/// Axes along which a body is narrower than the spacing, so that its one layer of particles is thicker than
/// itself: "0.004 m along z"; "" where there is none.
std::string narrowAxes(const Bounds& bounds, double spacing);

}  // namespace thaw
