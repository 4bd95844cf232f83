// SPDX-License-Identifier: Apache-2.0
// Order of the rows of a frame by id: the same in all frames and on any number of ranks.
#pragma once
#include <cstdint>
#include <vector>

#include "io/frames/frame.hpp"

namespace thaw {

/// Returns the 64-bit ids of the rows; empty if the frame has none.
std::vector<std::uint64_t> idsOf(const FrameData& frame);

/// Sorts rows, with all columns, by id. Sorts triangles by their corners, each with the smallest corner
/// first. Does nothing without ids.
void orderById(FrameData& frame);

}  // namespace thaw
