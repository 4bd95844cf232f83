// Where discs have to end: at the planes of neighbours beyond a crease, so that no rim stands out of an edge.
#pragma once
#include <cstdint>
#include <vector>

#include "io/render/depth_map.hpp"

namespace thaw {

/// The part of a disc that lies in front of a neighbour's plane is not drawn as far as that neighbour's own
/// disc goes: dot(q, normal) > reach and |q - other| < radius, with q and other (the neighbour) from the
/// disc's centre.
struct DiscClip {
  Vec3f normal;
  float reach = 0;
  Vec3f other;
  float radius2 = 0;
};

/// Clips of each disc, at most `most` a disc.
struct DiscClips {
  static constexpr std::size_t most = 8;
  std::vector<std::uint32_t> first;  ///< of a disc; discs + 1
  std::vector<DiscClip> list;
};

/// For discs with `wanted` not 0, over neighbours of the same component (all, if those are empty) nearer than
/// twice the larger radius.
DiscClips clipDiscs(const Discs& discs, std::span<const std::uint8_t> wanted,
                    std::span<const std::uint32_t> components);

}  // namespace thaw
