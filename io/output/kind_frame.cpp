#include "io/output/kind_frame.hpp"

#include "io/output/frame_rows.hpp"

namespace thaw {

WorldFrame kindFrameOf(const World& w, std::size_t kind) {
  const KindRows& r = kind == orientedKind ? static_cast<const KindRows&>(w.oriented.rows) : w.sheets.rows;
  WorldFrame f;
  f.frame.time = w.clock.time;
  f.frame.step = w.clock.step;
  f.frame.count = r.owned;
  addRows<float>(f, "position", "m", 3, [&](std::size_t i, float* to) { put3(r.position[i], to); });
  f.frame.positions = f.frame.fields[0];
  f.frame.fields.clear();
  addRows<std::uint64_t>(f, "id", "1", 1, [&](std::size_t i, std::uint64_t* to) { *to = r.id[i]; });
  addRows<float>(f, "velocity", "m/s", 3, [&](std::size_t i, float* to) { put3(r.velocity[i], to); });
  addRows<std::uint16_t>(f, (std::string(kindNames[kind]) + "_body").c_str(), "1", 1, [&](std::size_t i, std::uint16_t* to) { *to = r.body[i]; });
  if (kind == orientedKind) addOrientedFields(w, f);
  else addSheetFields(w, f);
  return f;
}

std::string titleOfFrame(const H5File& file) {
  for (const char* kind : kindNames)
    if (file.has(std::string("/VTKHDF/PointData/") + kind + "_body")) return kind;
  return isSurfaceFrame(file) ? "surfels" : "particles";
}

}  // namespace thaw
