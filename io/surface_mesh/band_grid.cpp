// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/band_grid.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {

namespace {

using Corner = BandGrid::Corner;

}  // namespace

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

void BandGrid::classify(const std::vector<std::uint8_t>& isInside) {
  // Nodes of a set: single corners of stored blocks, and whole blocks that are not stored (named by their
  // first corner).
  struct Node {
    Corner corner;
    bool block;
  };
  std::vector<Node> set;
  std::int64_t votes = 0;
  bool border = false;
  // Adds a corner to the set as `mark`, once; slots count for the majority.
  const auto reach = [&](const Corner& c, std::int32_t mark) {
    for (std::size_t a = 0; a < 3; a++)
      if (c[a] < first_[a] || c[a] > last_[a]) {
        border = border || first_[a] == 0;
        return;
      }
    std::int32_t& block = table_[static_cast<std::size_t>(blockOf(c))];
    if (block == open) {
      block = mark;
      set.push_back({{c[0] / side * side, c[1] / side * side, c[2] / side * side}, true});
    } else if (block >= 0) {
      std::int32_t& slot = kept_[static_cast<std::size_t>(block)].slot[within(c)];
      if (slot >= 0) votes += isInside[static_cast<std::size_t>(slot)] ? 1 : -1;
      if (slot != open) return;
      slot = mark;
      set.push_back({c, false});
    }
  };
  const auto spread = [&](const Node& n, std::int32_t mark) {
    const Corner& c = n.corner;
    if (!n.block) {
      for (int a = 0; a < 3; a++)
        for (const int step : {-1, 1}) {
          Corner next = c;
          next[a] += step;
          reach(next, mark);
        }
      return;
    }
    for (int a = 0; a < 3; a++)
      for (const std::int64_t step : {std::int64_t{-1}, side})
        for (std::int64_t u = 0; u < side; u++)
          for (std::int64_t v = 0; v < side; v++) {
            Corner next = c;
            next[a] += step, next[(a + 1) % 3] += u, next[(a + 2) % 3] += v;
            if (next[(a + 1) % 3] < count_[(a + 1) % 3] && next[(a + 2) % 3] < count_[(a + 2) % 3])
              reach(next, mark);
          }
  };
  const auto classifyFrom = [&](const Corner& first) {
    set.clear();
    votes = 0, border = false;
    reach(first, outside);
    for (std::size_t k = 0; k < set.size(); k++) {
      const Node n = set[k];  // copy: the list grows
      spread(n, outside);
    }
    if (border || votes <= 0) return;
    for (const Node& n : set) {
      if (n.block) table_[static_cast<std::size_t>(blockOf(n.corner))] = inside;
      else
        kept_[static_cast<std::size_t>(table_[static_cast<std::size_t>(blockOf(n.corner))])]
            .slot[within(n.corner)] = inside;
    }
  };
  // Every set is adjacent to a slot, or fills a grid without slots.
  for (std::size_t s = 0; s < corners_.size(); s++)
    for (int a = 0; a < 3; a++)
      for (const int step : {-1, 1}) {
        Corner next = corners_[s];
        next[a] += step;
        if (next[a] >= first_[a] && next[a] <= last_[a] && at(next) == open) classifyFrom(next);
      }
  if (corners_.empty()) std::fill(table_.begin(), table_.end(), outside);
}

}  // namespace thaw
