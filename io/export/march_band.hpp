// From values at the corners of a grid to triangles.
#pragma once
#include "io/export/band_grid.hpp"
#include "io/export/plane_field.hpp"
#include "io/export/surface_mesh.hpp"

namespace thaw {

/// What a corner of the grid knows: its nearest surfel, and weighted sums over those around. One a slot.
struct BandField {
  std::vector<float> nearest2;  // m^2
  std::vector<std::uint32_t> nearest;
  std::vector<float> weight, value;
  std::vector<Vec3f> offset, normal, colour;
};

/// Triangles, and what their vertices may not leave.
struct MarchedBand {
  static constexpr std::uint8_t onCap = 8;
  ComponentMesh mesh;
  std::vector<std::uint8_t> held;  ///< one a vertex: bits of the axes whose cut it lies on; onCap for those
                                   ///< within a cap
};

/// Marches all cubes that the surface crosses. Where the grid is cut, what is inside ends with a flat cap on
/// the plane, a vertex at each corner of the grid that is inside; corners far from all surfels have the
/// colour `deep` (sRGB 0 to 255).
MarchedBand marchBand(const BandGrid& grid, const BandField& field, const PlaneField& planes,
                      const Vec3f& deep);

/// Leaves out closed shells beside a larger one that are no surface: those of less than two cubes' volume (at
/// sharp edges nearest surfels may disagree for a corner or two), and those less than half of which lies on
/// discs (bubbles and lumps where the sides of a narrow crease disagree: a tenth mostly does; of what surfels
/// go round, nearly all).
void dropCrumbs(MarchedBand& band, const PlaneField& planes, double spacing);

}  // namespace thaw
