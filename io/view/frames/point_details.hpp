// SPDX-License-Identifier: Apache-2.0
// All fields of one point, for picking.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "io/view/frames/frame_packet.hpp"

namespace thaw {

/// A point by its index in the packet of a frame, or by its id.
struct PointChoice {
  std::optional<std::uint64_t> index, id;
};

/// Returns id (as text: it has 64 bits), index in the packet (-1: not drawn), position and all fields of a
/// point. Throws IoError for an unreadable frame, and if there is no such point in it.
nlohmann::ordered_json pointDetails(const FrameRequest& request, const PointChoice& point);

}  // namespace thaw
