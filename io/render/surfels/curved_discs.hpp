// SPDX-License-Identifier: Apache-2.0
// Surfels of strongly curved surfaces, drawn as several smaller discs on the surface, so drops are round and
// edges smooth.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "io/render/light/depth_map.hpp"

namespace thaw {

/// Disc in place of a surfel, with its surfel, and nearby surfels whose light and colour it mixes.
struct DiscPart {
  Vec3f position, normal;
  float radius = 0;
  std::uint32_t of = 0;
  bool atEdge = false;  ///< whole, on a flat face at a sharp edge
  struct Share {
    std::uint32_t of = 0;
    float share = 0;
  };
  std::array<Share, 4> mix{};  ///< shares sum to 1
};

/// Curvature along a disc's tangents u and v = n x u. The shape operator is a least-squares fit of the
/// turn of neighbours' normals (same component, within two radii).
struct DiscCurvature {
  Vec3f u;
  float uu = 0, uv = 0, vv = 0;  ///< 1/m, > 0 where the surface bends away from the normal
};
/// Returns zero curvature with too few neighbours, or if the fit is poor.
DiscCurvature curvatureOf(const Discs& discs, std::span<const std::uint32_t> components, std::uint32_t i,
                          std::span<const std::uint32_t> near);

/// Returns all discs. Those that bend too much are divided: `allowed` (m, per disc) is the largest gap
/// between a flat disc and the surface at its rim. A disc becomes 7, 19 or 37 parts, as needed. Parts lie
/// where the mean of nearby planes vanishes, and cover the area of the disc. Parts of a disc are consecutive.
std::vector<DiscPart> curvedDiscs(const Discs& discs, std::span<const std::uint32_t> components,
                                  const std::function<float(std::uint32_t)>& allowed);

}  // namespace thaw
