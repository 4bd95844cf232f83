// SPDX-License-Identifier: Apache-2.0
#include "io/frames/read_oriented_frame.hpp"

#include <cstring>

#include "core/math/quat.hpp"
#include "core/scene/oriented_body.hpp"
#include "io/frames/rows_by_id.hpp"

namespace thaw {

bool isOrientedFrame(const FrameInfo& info) {
  for (const FrameInfo::Field& f : info.fields)
    if (f.name == "oriented_body") return true;
  return false;
}

OrientedFrame readOrientedFrame(const std::string& path) {
  if (!isOrientedFrame(readFrameInfo(path)))
    throw IoError(path, "is not a frame of oriented particles (those are called NAME_oriented_000000.hdf)");
  FrameData data = readFrame(path);
  orderById(data);
  return orientedFrameOf(std::move(data), path);
}

OrientedFrame orientedFrameOf(FrameData data, const std::string& path) {
  const auto need = [&](const char* name) -> const FrameColumn& {
    const FrameColumn* c = data.find(name);
    if (!c) throw IoError(path, std::string("has no field '") + name + "'");
    return *c;
  };
  OrientedFrame f;
  f.time = data.time;
  f.step = data.step;
  f.ids = idsOf(data);
  f.positions = std::move(data.positions);
  const std::size_t n = f.positions.size();
  const FrameColumn &turn = need("orientation"), &radius = need("radius"), &group = need("group"),
                    &body = need("oriented_body"), &cut = need("cut_sides"), &flags = need("flags");
  const FrameColumn* colour = data.find("color");  // frames of earlier versions have none
  if (colour && colour->components != 3) colour = nullptr;
  f.cutSides.resize(n);
  if (n > 0) std::memcpy(f.cutSides.data(), cut.bytes.data(), n * sizeof(std::uint64_t));
  for (std::size_t i = 0; i < n; i++) {
    const Quat q = unitQuat(Quat{turn.value(i, 0), turn.value(i, 1), turn.value(i, 2), turn.value(i, 3)});
    f.normals.push_back(axisOf(q));
    f.tangents.push_back(rotated(q, {1, 0, 0}));
    f.spacings.push_back(radius.value(i));
    f.groups.push_back(static_cast<std::uint32_t>(group.value(i)));
    f.bodies.push_back(static_cast<std::uint32_t>(body.value(i)));
    const std::uint32_t plain = orientedColours[f.bodies.back() % std::size(orientedColours)];
    std::array<std::uint8_t, 3> rgb{};
    for (int c = 0; c < 3; c++)
      rgb[static_cast<std::size_t>(c)] = colour ? static_cast<std::uint8_t>(colour->value(i, c))
                                                : static_cast<std::uint8_t>(plain >> 8 * c & 255);
    f.colours.push_back(rgb);
    f.flags.push_back(static_cast<std::uint8_t>(flags.value(i)));
  }
  return f;
}

}  // namespace thaw
