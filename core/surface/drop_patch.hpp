// The surface of drops too small for a colour field: a sphere (docs/validation/stability.md B21).
#pragma once
#include <vector>

#include "core/surface/births.hpp"

namespace thaw {

/// Evenly spread surfels, 24 or as many as `spacing` (m) asks for, on a sphere of this volume (m^3) around
/// `centre`; their radius covers it without a hole. Ids follow from the component and the number, so that
/// they are the same in each update.
std::vector<SurfelRow> dropPatch(std::uint64_t component, const Vec3d& centre, double volume, double spacing);

}  // namespace thaw
