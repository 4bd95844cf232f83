// SPDX-License-Identifier: Apache-2.0
// Surfaces that join their own images through periodic sides, cut there with straight rims and flat caps.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "io/frames/read_surface_frame.hpp"
#include "io/surface_mesh/unwrap_component.hpp"

namespace thaw {

/// Axes, as bits, along which components are cut, by label.
using CutComponents = std::map<std::uint64_t, std::uint8_t>;

struct CutSides {
  std::vector<std::uint8_t> axes;                   ///< per row: axes along which it is cut, as bits
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< caps: their rows are not drawn as discs
};

/// Adds rows to a frame: images of surfels that continue the surface up to the sides, and corners of caps.
/// Caps lie where the surface encloses a part of a side. Added rows have the fields of the nearest surfel.
/// Corners of caps have the component `capComponent`.
CutSides closeCutSides(SurfaceFrame& frame, const CutComponents& cuts, const PeriodicSides& sides);
inline constexpr std::uint64_t capComponent = 0xfffffff2u;

}  // namespace thaw
