// SPDX-License-Identifier: Apache-2.0
// Local continuation of the surface between surfels.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/data/surfels.hpp"
#include "core/surface/search/row_lists.hpp"

namespace thaw {

/// Smallest dot product of normals on one side of a sheet, which allows sharp edges of up to 107 degrees.
inline constexpr double oneSide = -0.3;

/// A surfel and the surfels of its component on its side within `reach`, in row order.
struct Patch {
  const Surfels* surfels = nullptr;
  std::size_t centre = 0;
  std::vector<std::uint32_t> rows;
  std::vector<double> disc;  ///< buffers of projectToPatch and uncoveredPoint
  std::vector<float> seen;
  double curvature[3]{};  ///< 1/m, components ss, st, tt of the shape operator along the tangents; positive:
                          ///< convex

  void gather(const Surfels& s, std::size_t i, const RowLists& lists, double reach);
  /// Fits the rotation of normals by least squares; 0 if the neighbours do not determine it.
  void fitCurvature();
  /// Returns the largest magnitude of the principal curvatures (1/m).
  double largestCurvature() const;
};

/// Point on a patch's surface.
struct SurfacePoint {
  Vec3d position{}, normal{};  ///< m, unit
};

/// Returns the point of the patch at chord length `distance` (m) from its centre in the direction cosine *
/// tangent + sine * (normal x tangent).
SurfacePoint pointAround(const Patch& patch, double distance, double cosine, double sine);

/// Projects n <= 8 points onto the surface between the patch's surfels, including its centre. There, the
/// weighted mean of (n_j + n) . (x - x_j) vanishes. Weights vanish at `reach` (m). The projection is exact on
/// planes and spheres (co-circularity, ST92).
void projectToPatch(Patch& patch, SurfacePoint* points, std::size_t n, double reach);

}  // namespace thaw
