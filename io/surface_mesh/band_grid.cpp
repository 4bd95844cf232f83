// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/band_grid.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {

BandGrid::BandGrid(const Vec3d& origin, const Vec3d& spacing, const Corner& count,
                   const std::array<bool, 3>& cut)
    : origin_(origin), spacing_(spacing), count_(count) {
  for (std::size_t a = 0; a < 3; a++) {
    blocks_[a] = (count[a] + side - 1) / side;
    first_[a] = cut[a] ? 1 : 0;
    last_[a] = count[a] - (cut[a] ? 2 : 1);
  }
  table_.assign(static_cast<std::size_t>(blocks_[0] * blocks_[1] * blocks_[2]), open);
}

std::int32_t& BandGrid::entry(const Corner& c) {
  std::int32_t& block = table_[static_cast<std::size_t>(blockOf(c))];
  if (block < 0) {
    const std::int32_t was = block;
    block = static_cast<std::int32_t>(kept_.size());
    kept_.emplace_back();
    kept_.back().slot.fill(was);
  }
  return kept_[static_cast<std::size_t>(block)].slot[within(c)];
}

std::int32_t BandGrid::makeSlot(const Corner& c) {
  std::int32_t& slot = entry(c);
  if (slot < 0) {
    slot = static_cast<std::int32_t>(corners_.size());
    corners_.push_back(c);
  }
  return slot;
}

std::int32_t BandGrid::at(const Corner& c) const {
  if (beyond(c)) return outside;
  const std::int32_t block = table_[static_cast<std::size_t>(blockOf(c))];
  return block < 0 ? block : kept_[static_cast<std::size_t>(block)].slot[within(c)];
}

/// Connected set of corners without a slot. Nodes are single corners of stored blocks, and whole blocks that
/// are not stored, named by their first corner.
struct BandGrid::Region {
  struct Node {
    Corner corner;
    bool block;
  };
  BandGrid& grid;
  const std::vector<std::uint8_t>& isInside;
  std::vector<Node> nodes{};
  std::int64_t majority = 0;  // adjacent slots inside minus those outside
  bool atBorder = false;

  std::int32_t& blockAt(const Corner& c) const {
    return grid.table_[static_cast<std::size_t>(grid.blockOf(c))];
  }
  std::int32_t& slotAt(const Corner& c) const {
    return grid.kept_[static_cast<std::size_t>(blockAt(c))].slot[within(c)];
  }

  /// Adds an open corner as outside. Counts a slot for the majority.
  void reach(const Corner& c) {
    for (std::size_t a = 0; a < 3; a++)
      if (c[a] < grid.first_[a] || c[a] > grid.last_[a]) {
        atBorder = atBorder || grid.first_[a] == 0;
        return;
      }
    if (std::int32_t& block = blockAt(c); block == open) {
      block = outside;
      nodes.push_back({{c[0] / side * side, c[1] / side * side, c[2] / side * side}, true});
    } else if (block >= 0) {
      std::int32_t& slot = slotAt(c);
      if (slot >= 0) majority += isInside[static_cast<std::size_t>(slot)] ? 1 : -1;
      if (slot != open) return;
      slot = outside;
      nodes.push_back({c, false});
    }
  }

  /// Reaches all corners next to a node.
  void spread(Node n) {
    const std::int64_t size = n.block ? side : 1;
    for (std::size_t a = 0; a < 3; a++)
      for (const std::int64_t step : {std::int64_t{-1}, size})
        for (std::int64_t u = 0; u < size; u++)
          for (std::int64_t v = 0; v < size; v++) {
            const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
            Corner next = n.corner;
            next[a] += step, next[b] += u, next[c] += v;
            if (next[b] < grid.count_[b] && next[c] < grid.count_[c]) reach(next);
          }
  }
};

void BandGrid::classify(const std::vector<std::uint8_t>& isInside) {
  const auto classifyFrom = [&](const Corner& first) {
    Region region{*this, isInside};
    region.reach(first);
    for (std::size_t k = 0; k < region.nodes.size(); k++) region.spread(region.nodes[k]);  // the list grows
    if (region.atBorder || region.majority <= 0) return;
    for (const Region::Node& n : region.nodes)
      (n.block ? region.blockAt(n.corner) : region.slotAt(n.corner)) = inside;
  };
  if (corners_.empty()) {
    std::fill(table_.begin(), table_.end(), outside);
    return;
  }
  for (std::size_t block = 0; block < table_.size(); block++) {
    const auto number = static_cast<std::int64_t>(block);
    const Corner low{side * (number % blocks_[0]), side * (number / blocks_[0] % blocks_[1]),
                     side * (number / (blocks_[0] * blocks_[1]))};
    if (table_[block] == open)
      classifyFrom({std::max(low[0], first_[0]), std::max(low[1], first_[1]), std::max(low[2], first_[2])});
    if (table_[block] < 0) continue;
    const Block& stored = kept_[static_cast<std::size_t>(table_[block])];
    for (std::int64_t k = 0; k < side * side * side; k++)
      if (stored.slot[static_cast<std::size_t>(k)] == open)
        classifyFrom({low[0] + k % side, low[1] + k / side % side, low[2] + k / (side * side)});
  }
}

}  // namespace thaw
