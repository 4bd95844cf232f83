#include "io/output/frame_rows.hpp"
#include "io/output/kind_frame.hpp"

namespace thaw {

void addSheetFields(const World& w, WorldFrame& f) {
  const Sheets& s = w.sheets.rows;
  addRows<float>(f, "displacement", "m", 3, [&](std::size_t i, float* to) { put3(s.position[i] - s.rest[i], to); });
}

}  // namespace thaw
