// SPDX-License-Identifier: Apache-2.0
#include "io/frames/rows_by_id.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace thaw {

std::vector<std::uint64_t> idsOf(const FrameData& frame) {
  const FrameColumn* column = frame.find("id");
  if (!column || column->components != 1 ||
      column->bytes.size() != frame.positions.size() * sizeof(std::uint64_t))
    return {};
  std::vector<std::uint64_t> ids(frame.positions.size());
  if (!ids.empty()) std::memcpy(ids.data(), column->bytes.data(), column->bytes.size());
  return ids;
}

void orderById(FrameData& frame) {
  const std::vector<std::uint64_t> ids = idsOf(frame);
  if (ids.empty()) return;
  std::vector<std::uint32_t> rows(ids.size()), place(ids.size());
  std::iota(rows.begin(), rows.end(), 0u);
  std::stable_sort(rows.begin(), rows.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return ids[a] < ids[b]; });
  for (std::uint32_t k = 0; k < rows.size(); k++) place[rows[k]] = k;
  const std::vector<Vec3d> positions = frame.positions;
  for (std::size_t k = 0; k < rows.size(); k++) frame.positions[k] = positions[rows[k]];
  for (FrameColumn& c : frame.columns) {
    const std::size_t bytes = c.bytes.size() / rows.size();
    const std::vector<std::byte> before = c.bytes;
    for (std::size_t k = 0; k < rows.size(); k++)
      std::memcpy(c.bytes.data() + k * bytes, before.data() + rows[k] * bytes, bytes);
  }
  for (auto& t : frame.triangles) {
    for (std::uint32_t& corner : t) corner = place[corner];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(frame.triangles.begin(), frame.triangles.end());
}

}  // namespace thaw
