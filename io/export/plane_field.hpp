// The surface between surfels, at any place: the weighted mean of their planes.
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/bins.hpp"
#include "io/output/read_surface_frame.hpp"

namespace thaw {

inline constexpr double planeSharpness = 0.6;   ///< of a surfel's radius: width of the weights
inline constexpr float planeAgreement = -0.3f;  ///< least cosine of a normal to that of the nearest surfel:
                                                ///< the other side of a thin sheet does not count
/// Surfels count within this many of their radii, and `margin` more.
inline constexpr double planeReach = 1.5;

/// Signed height over the surface (m, outside above 0), 0 on it; its direction outward, not normalised; false
/// where no surfel is in reach.
struct PlaneHeight {
  double value = 0;
  Vec3f normal{};
  bool known = false;
};

/// Kolluri 2005's implicit moving least squares over the nearest surfels, corrected for curvature by the mean
/// normal: planes of a curved surface lie outside of it, but the chord to a surfel is square to the mean of
/// both ends' normals, exactly so on a sphere.
class PlaneField {
 public:
  PlaneField(const SurfaceFrame& frame, const std::vector<std::uint32_t>& rows, double margin);
  PlaneHeight at(const Vec3d& x) const;
  /// Is a disc there that looks the same way, rather than only the plane of one farther off, or of one that
  /// looks elsewhere?
  bool onDisc(const Vec3d& x, const Vec3f& normal) const;

 private:
  const SurfaceFrame& frame_;
  const std::vector<std::uint32_t>& rows_;
  double margin_, farthest_ = 0;
  Bins bins_;
};

}  // namespace thaw
