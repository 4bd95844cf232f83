// SPDX-License-Identifier: Apache-2.0
// Thinning of the frames and points of a page.
#pragma once
#include <cstddef>
#include <cstdint>

namespace thaw {

struct Thinning {
  std::size_t every = 1;        ///< keeps every n-th frame and the last one
  std::uint64_t most = 500000;  ///< points of each type, about: as many as browsers draw
  bool tensors = true;          ///< with fields of six components
  bool particles = true;        ///< with particles in frames that have a surface
  bool meshes = true;           ///< with meshes of surfaces
};

struct PageSizes {
  std::size_t frames = 0;    ///< frames of the run
  std::uint64_t points = 0;  ///< points of the largest encoded frame
  bool tensors = false;      ///< whether some were encoded
  bool meshes = false;       ///< the same
  bool spare = false;        ///< whether particles of a frame with a surface were encoded
};

/// Returns whether a frame is in the page.
inline bool isKept(std::size_t frame, const PageSizes& sizes, const Thinning& t) {
  return frame % t.every == 0 || frame + 1 == sizes.frames;
}

/// Increases the thinning. The order is: no tensors, frames down to 60, no particles beside a surface, frames
/// down to 8, points down to 1500. Then follow frames and points in turn, and no meshes. A step leaves three
/// quarters of the points or, above four frames, at least half of the frames. Returns false if no further
/// thinning is possible.
bool thinFurther(const PageSizes& sizes, Thinning& t);

}  // namespace thaw
