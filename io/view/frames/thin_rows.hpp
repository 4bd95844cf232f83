// SPDX-License-Identifier: Apache-2.0
// Choice of rows of large frames. A row is drawn in all frames or in none, so points do not flicker.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "io/frames/frame.hpp"

namespace thaw {

inline constexpr double levelStep = 0.5;

/// Returns the smallest level, a multiple of levelStep, at which about `most` of `count` rows are left. A
/// level keeps one row in 2^level.
double thinningLevel(std::uint64_t count, std::uint64_t most);

/// Returns whether a row stays at a level. This depends on a hash of the id. A row that stays at one level
/// stays at all lower levels.
bool staysAt(double level, std::uint64_t id);

/// Returns the rows of finite positions that stay, ascending. ids: empty if the frame has none; then the row
/// counts as its id.
std::vector<std::uint32_t> rowsAt(double level, std::span<const Vec3d> positions,
                                  std::span<const std::uint64_t> ids);

/// Keeps these rows of a frame, ascending, and the triangles between them.
void keepRows(FrameData& frame, std::span<const std::uint32_t> rows);

}  // namespace thaw
