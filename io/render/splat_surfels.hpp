// The two passes of splatting: which surfel is in front at each sample, and the mean of those around it.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "io/render/disc_clips.hpp"
#include "io/render/linear_light.hpp"
#include "io/render/view.hpp"

namespace thaw {

/// What surfels carry into the picture, and what a sample gets: the weighted mean.
struct SurfelShade {
  Vec3f normal;
  Light fromSky;  ///< light of the sky that leaves the surface
  Light ofSun;    ///< colour that the sun would show where it shines straight on
  float sun = 1;  ///< part of the sun that is seen
};

struct CameraFaces;

struct SurfelScene {
  Discs discs;  ///< as they are drawn
  const DiscClips& clips;
  std::span<const SurfelShade> shades;
  std::span<const std::uint32_t> components;  ///< may be empty
  const CameraFaces& faces;
  std::span<const SurfelShade> corners;  ///< light of the faces' corners
};

/// A square of samples; depth infinite where there is no surface. Row by row.
struct SurfelTile {
  static constexpr int side = 64;
  int x = 0, y = 0, width = 0, height = 0;  ///< samples
  std::vector<float> depth;                 ///< m along the view
  std::vector<SurfelShade> shade;
};

/// Sets `seen` for discs that face the camera and lie in the picture.
std::vector<std::uint8_t> facingDiscs(const Discs& discs, const View& view, int width, int height,
                                      float near);

/// Draws discs with `seen` on width x height samples, tile by tile; `take` gets each tile, from several
/// threads at once where asked for.
void splatSurfels(const SurfelScene& scene, std::span<const std::uint8_t> seen, const View& view, int width,
                  int height, int threads, const std::function<void(const SurfelTile&)>& take);

}  // namespace thaw
