// SPDX-License-Identifier: Apache-2.0
#include "io/render/surfels/surfel_rows.hpp"

namespace thaw {

SurfaceFrame rowsOf(const SurfaceFrame& from, const std::vector<std::uint32_t>& rows) {
  SurfaceFrame to;
  to.time = from.time, to.step = from.step, to.sceneName = from.sceneName, to.sceneText = from.sceneText;
  for (const std::uint32_t i : rows) {
    to.positions.push_back(from.positions[i]);
    to.normals.push_back(from.normals[i]);
    to.radii.push_back(from.radii[i]);
    to.colours.push_back(from.colours[i]);
    to.ids.push_back(from.ids[i]);
    to.components.push_back(from.components[i]);
  }
  for (const FrameColumn& c : from.columns) {
    const auto width = static_cast<std::ptrdiff_t>(c.bytes.size() / from.positions.size());
    FrameColumn column{c.name, c.unit, c.element, c.components, {}};
    column.bytes.reserve(rows.size() * static_cast<std::size_t>(width));
    for (const std::uint32_t i : rows)
      column.bytes.insert(column.bytes.end(), c.bytes.begin() + i * width, c.bytes.begin() + (i + 1) * width);
    to.columns.push_back(std::move(column));
  }
  return to;
}

}  // namespace thaw
