// SPDX-License-Identifier: Apache-2.0
// Clips of discs at the planes of neighbours beyond a crease, so no rim protrudes from an edge.
#pragma once
#include <cstdint>
#include <vector>

#include "io/render/light/depth_map.hpp"

namespace thaw {

/// Clip of a disc. The part in front of a neighbour's plane and within that neighbour's disc is not drawn:
/// dot(q, normal) > reach and |q - other| < radius. q and other (the neighbour) are relative to the disc's
/// centre.
struct DiscClip {
  Vec3f normal;
  float reach = 0;
  Vec3f other;
  float radius2 = 0;
};

/// Clips of each disc, at most `most` per disc.
struct DiscClips {
  static constexpr std::size_t most = 8;
  std::vector<std::uint32_t> first;  ///< per disc; discs + 1
  std::vector<DiscClip> list;
};

/// Finds clips for discs with `wanted` not 0, from neighbours nearer than twice the larger radius. They are
/// of the same component, or of any if `components` is empty.
DiscClips clipDiscs(const Discs& discs, std::span<const std::uint8_t> wanted,
                    std::span<const std::uint32_t> components);

}  // namespace thaw
