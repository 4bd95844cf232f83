// SPDX-License-Identifier: Apache-2.0
#include "io/frames/body_type_frame.hpp"

#include "io/frames/frame_rows.hpp"

namespace thaw {

Frame bodyTypeFrameOf(const World& w, std::size_t kind) {
  const BodyTypeRows& r = kind == orientedType ? static_cast<const BodyTypeRows&>(w.oriented.rows)
                                               : w.sheets.rows;
  Frame f = startFrame(w.clock, r);
  addRows<float>(f, "velocity", "m/s", 3, [&r](std::size_t i, float* to) { put3(r.velocity[i], to); });
  addRows<std::uint16_t>(f, std::string(bodyTypeNames[kind]) + "_body", "1", 1,
                         [&r](std::size_t i, std::uint16_t* to) { *to = r.body[i]; });
  if (kind == orientedType) addOrientedFields(w, f);
  else addSheetFields(w, f);
  return f;
}

std::string pointTypeOf(const H5File& file) {
  for (const char* kind : bodyTypeNames)
    if (file.has(std::string("/VTKHDF/PointData/") + kind + "_body")) return kind;
  return isSurfaceFrame(file) ? "surfels" : "particles";
}

}  // namespace thaw
