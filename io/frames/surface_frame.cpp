// SPDX-License-Identifier: Apache-2.0
#include "io/frames/surface_frame.hpp"

#include <algorithm>

#include "io/frames/frame_rows.hpp"

namespace thaw {

std::string surfaceName(const std::string& scene) { return scene + "_surface"; }

bool wantsSurfelVelocities(const Scene& s) {
  return std::find(s.output.fields.begin(), s.output.fields.end(), surfaceVelocityField) !=
         s.output.fields.end();
}

Frame surfaceFrameOf(const Surface& surface, const Clock& clock, const std::vector<Vec3d>& velocities) {
  const Surfels& s = surface.surfels;
  Frame f = startFrame(clock, s);
  addRows<float>(f, "normal", "1", 3, [&s](std::size_t i, float* to) { put3(s.normal[i], to); });
  addRows<float>(f, "radius", "m", 1,
                 [&s](std::size_t i, float* to) { *to = static_cast<float>(s.radius[i]); });
  addRows<std::uint8_t>(f, "color", "1", 3, [&s](std::size_t i, std::uint8_t* to) {
    for (int c = 0; c < 3; c++) to[c] = static_cast<std::uint8_t>(s.colour[i] >> 8 * c & 255);
  });
  addRows<std::uint64_t>(f, "component", "1", 1,
                         [&s](std::size_t i, std::uint64_t* to) { *to = s.component[i]; });
  addRows<float>(f, "detail", "1", 1, [&s](std::size_t i, float* to) { *to = s.detail[i]; });
  if (s.liquid.active)
    addRows<float>(f, "liquid", "1", 1, [&s](std::size_t i, float* to) { *to = s.liquid[i]; });
  if (s.temperature.active)
    addRows<float>(f, "temperature", "K", 1, [&s](std::size_t i, float* to) { *to = s.temperature[i]; });
  if (!velocities.empty())
    addRows<float>(f, "velocity", "m/s", 3,
                   [&velocities](std::size_t i, float* to) { put3(velocities[i], to); });
  return f;
}

bool isSurfaceFrame(const H5File& file) {
  return file.has("/VTKHDF/PointData/normal") && file.has("/VTKHDF/PointData/radius");
}

}  // namespace thaw
