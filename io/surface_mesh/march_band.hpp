// SPDX-License-Identifier: Apache-2.0
// Triangles of the zero set from values at grid corners.
#pragma once
#include "io/surface_mesh/band_grid.hpp"
#include "io/surface_mesh/plane_field.hpp"
#include "io/surface_mesh/surface_mesh.hpp"

namespace thaw {

/// Triangles, with constraints of their vertices.
struct MarchedBand {
  static constexpr std::uint8_t onCap = 8;
  ComponentMesh mesh;
  std::vector<std::uint8_t> fixedAxes;  ///< per vertex: bits of the axes on whose cut it lies, and onCap
                                        ///< inside a cap
};

/// Marches all cubes that the surface crosses. At a cut the inside ends with a flat cap on the plane, with a
/// vertex at each inside corner. Corners far from all surfels have the colour `deep` (sRGB 0 to 255).
/// projectedLater: vertices and normals are interpolated between corners, for improveTriangles.
MarchedBand marchBand(const BandGrid& grid, const BandHeights& heights, const PlaneField& planes,
                      const Vec3f& deep, bool projectedLater);

/// Removes spurious closed shells next to a larger one. A shell is spurious if its volume is below two cubes,
/// since nearest surfels may disagree at sharp edges. It is also spurious if less than half of its area is on
/// discs. Bubbles and fragments in narrow creases have about a tenth of their area on discs, real surfaces
/// nearly all.
void removeFragments(MarchedBand& band, const PlaneField& planes, double spacing);

}  // namespace thaw
