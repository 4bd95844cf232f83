// Draws surfels as one smooth lit surface: discs blended into each other where they overlap (elliptical
// weighted average splatting after Zwicker, Pfister, van Baar, Gross 2001, in the two passes of Botsch,
// Hornung, Zwicker, Kobbelt 2005), with soft shadows and light from the sky.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "io/render/render.hpp"

namespace thaw {

/// What is drawn: one element a surfel. values and colours may be empty, components as well (then all is one
/// body).
struct SurfelInput {
  std::span<const Vec3f> positions;           ///< m
  std::span<const Vec3f> normals;             ///< unit, outward
  std::span<const float> radii;               ///< m; neighbours at most this far apart leave no hole
  std::span<const float> values;              ///< in the unit of the colour scale
  std::span<const Rgb> colours;               ///< of the surface
  std::span<const std::uint32_t> components;  ///< bodies do not blend into each other
  std::span<const std::array<std::uint32_t, 3>> faces{};  ///< triangles between rows, drawn instead of these;
                                                          ///< seen from where the rows turn counterclockwise
};

/// What colours: nothing, the values by the style's colours, the surface's own colours, or those turning into
/// the values' colours as the values rise from the lowest to the highest of the scale; Mixed: the values
/// where there are any (not NaN), else own colours.
enum class SurfelPaint { Plain, Values, Surface, Glow, Mixed };

struct SurfelStyle {
  SurfelPaint paint = SurfelPaint::Plain;
  float discs = 1.25f;  ///< drawn radius over the surfel's
  int threads = 1;
};

/// The picture, without text: the same for any number of threads. Surfels with numbers that are not finite
/// are left out. Throws std::invalid_argument if the sizes of the spans or of the picture make no sense, or
/// colours or values are missing.
Image renderSurfels(const SurfelInput& input, const RenderStyle& style, const SurfelStyle& surfels);

}  // namespace thaw
