// SPDX-License-Identifier: Apache-2.0
#include "io/frames/body_type_frame.hpp"
#include "io/frames/frame_rows.hpp"

namespace thaw {

void addOrientedFields(const World& w, Frame& f) {
  const Oriented& o = w.oriented.rows;
  addRows<float>(f, "normal", "1", 3, [&o](std::size_t i, float* to) { put3(axisOf(o.orientation[i]), to); });
  addRows<float>(f, "orientation", "1", 4, [&o](std::size_t i, float* to) {
    const Quat& q = o.orientation[i];
    to[0] = static_cast<float>(q.w), to[1] = static_cast<float>(q.x), to[2] = static_cast<float>(q.y),
    to[3] = static_cast<float>(q.z);
  });
  // as for surfels: discs of neighbours at most this far apart leave no hole
  addRows<float>(f, "radius", "m", 1, [&w, &o](std::size_t i, float* to) {
    *to = static_cast<float>(spacingOf(w.scene, w.scene.oriented[o.body[i]]));
  });
  addRows<std::uint8_t>(f, "color", "1", 3, [&w, &o](std::size_t i, std::uint8_t* to) {
    for (int c = 0; c < 3; c++)
      to[c] = static_cast<std::uint8_t>(colourOf(w.scene.oriented[o.body[i]], o.body[i]) >> 8 * c & 255);
  });
  addRows<std::uint32_t>(f, "group", "1", 1, [&o](std::size_t i, std::uint32_t* to) { *to = o.group[i]; });
  addRows<std::uint64_t>(f, "cut_sides", "1", 1,
                         [&o](std::size_t i, std::uint64_t* to) { *to = o.cutSides[i]; });
  addRows<std::uint8_t>(f, "flags", "1", 1, [&o](std::size_t i, std::uint8_t* to) { *to = o.flags[i]; });
}

}  // namespace thaw
