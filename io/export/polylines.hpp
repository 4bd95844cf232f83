// SPDX-License-Identifier: Apache-2.0
// Curves of lines that share vertices.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace thaw {

/// Returns runs of vertices that cover each line once. A run ends at a vertex that does not have exactly two
/// lines. The run of a closed curve ends at its first vertex.
std::vector<std::vector<std::uint32_t>> polylinesOf(std::span<const std::array<std::uint32_t, 2>> lines);

}  // namespace thaw
