// Rows of a frame in the order of their ids: the same in all frames, and on any number of ranks.
#pragma once
#include <cstdint>
#include <vector>

#include "io/output/frame.hpp"

namespace thaw {

/// Ids of the rows, of all their 64 bits; empty where the frame has none.
std::vector<std::uint64_t> idsOf(const FrameData& frame);

/// Brings rows, with all columns, into the order of their ids, and triangles, each from its first corner on,
/// into that of their corners. Nothing where there are no ids.
void orderById(FrameData& frame);

}  // namespace thaw
