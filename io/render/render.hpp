// Draws particles as shaded spheres with a depth buffer, a shadow of the sun, and light from the sky.
// Deterministic; one thread.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "core/geometry/signed_distance.hpp"
#include "core/math/mat3.hpp"
#include "io/render/colour_map.hpp"
#include "io/render/image.hpp"
#include "io/render/view.hpp"

namespace thaw {

/// What is drawn. All spans have one element a particle, but radii may have one for all and values may be
/// empty (then all are grey).
struct RenderInput {
  std::span<const Vec3f> positions;  ///< m
  std::span<const float> values;     ///< in the unit of the colour scale
  std::span<const float> radii;      ///< m
};

/// A plane of the scene, drawn as a floor with the shadow on it, where its front (the side of the normal) is
/// seen.
struct FloorHint {
  Vec3d point{}, normal{0, 0, 1};  ///< m; unit vector
};

/// A solid thing drawn as if of clear glass.
struct GlassHint {
  std::shared_ptr<const SignedDistance> shape;
  Mat3d turn = identity3<double>();  ///< pose: x = move + turn x_shape
  Vec3d move{};                      ///< m
};

struct RenderStyle {
  int width = 1280, height = 960;  ///< pixels
  int samples = 2;                 ///< samples a pixel along each axis, 1 to 4
  Camera camera;                   ///< as it is: fitting is the caller's business (fittedCamera)
  ColourScale colours;
  float spacing = 0;  ///< m, distance of particles, for normals of the surface; 0: from the radii
  std::vector<FloorHint> floors;
  std::vector<GlassHint> glasses;
  ViewBox stage;  ///< m, what the camera is about: floors fade away from it; empty: the particles
};

/// The picture, without text. Particles with a position that is not finite are left out.
/// Throws std::invalid_argument if the sizes of the spans or of the picture make no sense.
Image render(const RenderInput& input, const RenderStyle& style);

}  // namespace thaw
