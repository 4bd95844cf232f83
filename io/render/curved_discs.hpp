// Surfels of strongly curved surfaces, drawn as several smaller discs on the surface between them: small
// drops and rims are round, edges have no rags.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "io/render/depth_map.hpp"

namespace thaw {

/// A disc in place of a surfel, the surfel that it is of, and the surfels around whose light and colour it
/// mixes.
struct DiscPart {
  Vec3f position, normal;
  float radius = 0;
  std::uint32_t of = 0;
  bool atEdge = false;  ///< whole, on a flat face beside a sharp edge
  struct Share {
    std::uint32_t of = 0;
    float share = 0;
  };
  std::array<Share, 4> mix{};  ///< shares make 1
};

/// The curvature along a disc's tangents u and v = n x u: the shape operator, least squares over how the
/// neighbours' normals turn (of the same component, within two radii).
struct DiscCurvature {
  Vec3f u;
  float uu = 0, uv = 0, vv = 0;  ///< 1/m, > 0 where the surface bends away from the normal
};
/// Zero where there are too few neighbours, or where their normals do not turn evenly.
DiscCurvature curvatureOf(const Discs& discs, std::span<const std::uint32_t> components, std::uint32_t i,
                          std::span<const std::uint32_t> near);

/// All discs, those that bend by more than a length allows in parts: `allowed` (m, of a disc) is how far a
/// flat one may be off the surface at its rim. A disc becomes 7, 19 or 37, whichever is enough. Parts lie
/// where the mean of the planes around vanishes, and cover what the disc covered. Parts of a disc follow each
/// other.
std::vector<DiscPart> curvedDiscs(const Discs& discs, std::span<const std::uint32_t> components,
                                  const std::function<float(std::uint32_t)>& allowed);

}  // namespace thaw
