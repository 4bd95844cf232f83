// SPDX-License-Identifier: Apache-2.0
// Texture coordinates of surfels, from the meshes of their bodies.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/scene/scene.hpp"
#include "io/frames/read_surface_frame.hpp"
#include "io/meshes/texture_coordinates.hpp"

namespace thaw {

/// Texture coordinates by id of surfel. A surfel keeps its coordinates throughout the run.
class SurfaceUv {
 public:
  /// Samples the bodies again, as at the start of the run. Skips bodies without texture coordinates. Throws
  /// std::exception if a mesh file is missing.
  explicit SurfaceUv(const Scene& scene);
  bool empty() const { return uv_.empty(); }
  /// Gives new surfels the coordinates of the nearest known surfel of their component. Requires: it is called
  /// for all surface frames in order of time, from the first one.
  void addBirths(const SurfaceFrame& frame);
  /// Returns the coordinates of each surfel, NaN where it has none.
  std::vector<Uv> of(const SurfaceFrame& frame) const;

 private:
  std::unordered_map<std::uint64_t, Uv> uv_;
};

/// Returns the texture coordinates of a run's surfels over its surface frames, given in order of time. They
/// are empty if no body has texture coordinates.
SurfaceUv followUv(const Scene& scene, const std::vector<std::filesystem::path>& frames);

}  // namespace thaw
