// SPDX-License-Identifier: Apache-2.0
#include "io/view/frames/thin_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/math/hash_random.hpp"

namespace thaw {

double thinningLevel(std::uint64_t count, std::uint64_t most) {
  const auto limit = static_cast<double>(std::max<std::uint64_t>(most, 1));
  double level = 0;
  while (level < 63 && static_cast<double>(count) * std::exp2(-level) > limit) level += levelStep;
  return level;
}

bool staysAt(double level, std::uint64_t id) {
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15ull;  // separates small ids, as in randomBits
  return level <= 0 || static_cast<double>(mixBits(mixBits(id + odd))) < std::exp2(64 - level);
}

std::vector<std::uint32_t> rowsAt(double level, std::span<const Vec3d> positions,
                                  std::span<const std::uint64_t> ids) {
  std::vector<std::uint32_t> rows;
  for (std::size_t i = 0; i < positions.size(); i++) {
    const Vec3d& x = positions[i];
    const bool finite = std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
    if (finite && staysAt(level, ids.empty() ? i : ids[i])) rows.push_back(static_cast<std::uint32_t>(i));
  }
  return rows;
}

void keepRows(FrameData& frame, std::span<const std::uint32_t> rows) {
  const std::size_t before = frame.positions.size();
  if (rows.size() == before) return;
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(before, none);
  for (std::size_t k = 0; k < rows.size(); k++) {
    place[rows[k]] = static_cast<std::uint32_t>(k);
    frame.positions[k] = frame.positions[rows[k]];
  }
  frame.positions.resize(rows.size());
  for (FrameColumn& column : frame.columns) {
    const std::size_t width = column.bytes.size() / before;
    for (std::size_t k = 0; k < rows.size(); k++)
      std::memmove(column.bytes.data() + k * width, column.bytes.data() + rows[k] * width, width);
    column.bytes.resize(rows.size() * width);
  }
  std::erase_if(frame.triangles, [&](const std::array<std::uint32_t, 3>& t) {
    return place[t[0]] == none || place[t[1]] == none || place[t[2]] == none;
  });
  for (auto& triangle : frame.triangles)
    for (std::uint32_t& corner : triangle) corner = place[corner];
}

}  // namespace thaw
