// SPDX-License-Identifier: Apache-2.0
// Selection of rows of a surface frame.
#pragma once
#include <cstdint>
#include <vector>

#include "io/frames/read_surface_frame.hpp"

namespace thaw {

/// Returns a frame with these rows of another, which may be repeated.
SurfaceFrame rowsOf(const SurfaceFrame& from, const std::vector<std::uint32_t>& rows);

}  // namespace thaw
