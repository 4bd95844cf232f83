// SPDX-License-Identifier: Apache-2.0
// Rendering of surfels as a smooth lit surface: overlapping discs are blended by elliptical weighted average
// splatting (ZPBG01), in the two passes of BHZK05. There are soft shadows and sky light.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "io/render/particles/render.hpp"
#include "io/surface_mesh/unwrap_component.hpp"

namespace thaw {

/// Surfels to draw, one element each. values, colours and components may be empty (without components all is
/// one body).
struct SurfelInput {
  std::span<const Vec3f> positions;           ///< m
  std::span<const Vec3f> normals;             ///< unit, outward
  std::span<const float> radii;               ///< m; neighbours within this distance leave no hole
  std::span<const float> values;              ///< in the unit of the colour scale
  std::span<const Rgb> colours;               ///< surface colours
  std::span<const std::uint32_t> components;  ///< bodies do not blend into each other
  /// Triangles between rows, drawn instead of their discs; counter-clockwise seen from the front.
  std::span<const std::array<std::uint32_t, 3>> faces{};
  /// Triangles that cast the shadows of the last `solidFaces` faces, fewer and larger than these.
  std::span<const std::array<Vec3f, 3>> solids{};
  std::size_t solidFaces = 0;
  /// Per row: bits of the axes at whose sides the surface ends. Rows beyond the list have none.
  std::span<const std::uint8_t> cutAxes{};
  PeriodicSides sides{};
};

/// Source of colours. Plain: none. Values: values by the style's colours. Surface: the surface's own colours.
/// Glow: own colours that blend into the values' colours as values rise over the scale. Mixed: values if not
/// NaN, else own colours.
enum class SurfelPaint { Plain, Values, Surface, Glow, Mixed };

struct SurfelStyle {
  SurfelPaint paint = SurfelPaint::Plain;
  float discs = 1.25f;  ///< drawn radius, as a multiple of the surfel's
  int threads = 1;
};

/// Draws the picture without text, the same for any number of threads. Surfels with non-finite numbers are
/// skipped. Throws std::invalid_argument for invalid sizes of spans or picture, or missing colours or values.
Image renderSurfels(const SurfelInput& input, const RenderStyle& style, const SurfelStyle& surfels);

}  // namespace thaw
