#include "io/output/frame_rows.hpp"
#include "io/output/kind_frame.hpp"

namespace thaw {

void addOrientedFields(const World& w, WorldFrame& f) {
  const Oriented& o = w.oriented.rows;
  addRows<float>(f, "normal", "1", 3, [&](std::size_t i, float* to) { put3(axisOf(o.orientation[i]), to); });
}

}  // namespace thaw
