// SPDX-License-Identifier: Apache-2.0
#include "io/frames/read_surface_frame.hpp"

#include <algorithm>
#include <cstring>

namespace thaw {

namespace {

/// Returns whole numbers, exact if the file has 64 bits.
std::vector<std::uint64_t> wholeNumbers(const FrameColumn& column, std::size_t count) {
  std::vector<std::uint64_t> numbers(count);
  if ((column.element == Element::U64 || column.element == Element::I64) && column.components == 1) {
    if (count > 0) std::memcpy(numbers.data(), column.bytes.data(), count * sizeof(std::uint64_t));
  } else {
    for (std::size_t i = 0; i < count; i++)
      numbers[i] = static_cast<std::uint64_t>(std::max(0.0, column.value(i)));
  }
  return numbers;
}

const char* const own[] = {"normal", "radius", "color", "id", "component"};

}  // namespace

const FrameColumn* SurfaceFrame::find(const std::string& name) const {
  for (const FrameColumn& c : columns)
    if (c.name == name) return &c;
  return nullptr;
}

bool isSurfaceFrame(const FrameInfo& info) {
  bool normal = false, radius = false;
  for (const FrameInfo::Field& f : info.fields) {
    normal = normal || (f.name == "normal" && f.shape.components == 3);
    radius = radius || (f.name == "radius" && f.shape.components <= 1);
  }
  return normal && radius;
}

SurfaceFrame readSurfaceFrame(const std::string& path,
                              const std::function<bool(const std::string&)>& wanted) {
  if (!isSurfaceFrame(readFrameInfo(path))) throw IoError(path, noSurfaceFrame);
  FrameData data = readFrame(path, [&](const std::string& name) {
    return std::find(std::begin(own), std::end(own), name) != std::end(own) || !wanted || wanted(name);
  });
  SurfaceFrame frame;
  const std::size_t n = data.positions.size();
  frame.time = data.time;
  frame.step = data.step;
  frame.sceneName = std::move(data.sceneName);
  frame.sceneText = std::move(data.sceneText);
  frame.positions = std::move(data.positions);
  frame.normals.resize(n);
  frame.radii.resize(n);
  frame.colours.assign(n, {200, 200, 200});
  frame.ids.assign(n, 0);
  frame.components.assign(n, 0);
  for (FrameColumn& column : data.columns) {
    const auto number = [&](std::size_t i, int c = 0) { return static_cast<float>(column.value(i, c)); };
    if (column.name == "normal") {
      for (std::size_t i = 0; i < n; i++) frame.normals[i] = {number(i, 0), number(i, 1), number(i, 2)};
    } else if (column.name == "radius") {
      for (std::size_t i = 0; i < n; i++) frame.radii[i] = number(i);
    } else if (column.name == "color" && column.components == 3) {
      for (std::size_t i = 0; i < n; i++) {
        const auto byte = [&](int c) {
          return static_cast<std::uint8_t>(std::clamp(column.value(i, c), 0.0, 255.0));
        };
        frame.colours[i] = {byte(0), byte(1), byte(2)};
      }
    } else if (column.name == "id") {
      frame.ids = wholeNumbers(column, n);
    } else if (column.name == "component") {
      frame.components = wholeNumbers(column, n);
    } else {
      frame.columns.push_back(std::move(column));
      continue;
    }
    column.bytes = {};
  }
  return frame;
}

}  // namespace thaw
