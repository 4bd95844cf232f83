// SPDX-License-Identifier: Apache-2.0
// Splatting in two passes: the front surfel at each sample, then the mean of the surfels around the visible
// point.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "io/image/linear_light.hpp"
#include "io/image/view.hpp"
#include "io/render/surfels/disc_clips.hpp"

namespace thaw {

/// Shading attributes of surfels, and their weighted mean at a sample.
struct SurfelShade {
  Vec3f normal;
  Light fromSky;  ///< sky light reflected by the surface
  Light ofSun;    ///< colour at normal incidence of the sun
  float sun = 1;  ///< visible fraction of the sun
};

struct CameraFaces;

struct SurfelScene {
  Discs discs;  ///< as drawn
  const DiscClips& clips;
  std::span<const SurfelShade> shades;
  std::span<const std::uint32_t> components;  ///< may be empty
  const CameraFaces& faces;
  std::span<const SurfelShade> corners;  ///< shades of the faces' corners
};

/// Square of samples, row by row; depth is infinite without a surface.
struct SurfelTile {
  static constexpr int side = 64;
  int x = 0, y = 0, width = 0, height = 0;  ///< samples
  std::vector<float> depth;                 ///< m along the view
  std::vector<SurfelShade> shade;
};

/// Returns 1 for discs that face the camera and lie in the picture.
std::vector<std::uint8_t> facingDiscs(const Discs& discs, const View& view, int width, int height,
                                      float near);

/// Draws discs with `seen` on width x height samples, tile by tile. Calls take(tile), from `threads` threads
/// in parallel.
void splatSurfels(const SurfelScene& scene, std::span<const std::uint8_t> seen, const View& view, int width,
                  int height, int threads, const std::function<void(const SurfelTile&)>& take);

}  // namespace thaw
