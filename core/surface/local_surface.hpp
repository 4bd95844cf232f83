// The surface between surfels: where it goes on around one of them.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/row_lists.hpp"
#include "core/surface/surfels.hpp"

namespace thaw {

/// Do surfels of these normals belong to one side of a sheet? Up to sharp edges of 107 degrees.
inline constexpr double oneSide = -0.3;

/// A surfel and those of its component and its side within `reach`, nearest or not, in row order.
struct Patch {
  const Surfels* surfels = nullptr;
  std::size_t centre = 0;
  std::vector<std::uint32_t> rows;
  std::vector<double> disc;  ///< buffers of ontoSurface and emptyPlace
  std::vector<float> seen;
  double curvature[3]{};  ///< 1/m, ss, st, tt of the shape operator along the tangents; positive: convex

  void gather(const Surfels& s, std::size_t i, const RowLists& lists, double reach);
  /// Least squares of how the normals turn; 0 where the neighbours do not say.
  void fitCurvature();
  /// The largest of the principal curvatures' magnitudes, 1/m.
  double largestCurvature() const;
};

/// Where the surface of a patch comes nearest.
struct SurfacePoint {
  Vec3d position{}, normal{};
};

/// The point of the patch at chord length `distance` (m) from its centre in the direction cosine * tangent +
/// sine * (normal x tangent).
SurfacePoint pointAround(const Patch& patch, double distance, double cosine, double sine);

/// Moves points onto the surface that lies between the patch's surfels, the centre included, by weights that
/// fall to 0 at `reach`: where the mean of (n_j + n) . (x - x_j) vanishes, which is exact on planes and
/// spheres (ST92's co-circularity). Of n <= 8 points at once.
void ontoSurface(Patch& patch, SurfacePoint* points, std::size_t n, double reach);

}  // namespace thaw
