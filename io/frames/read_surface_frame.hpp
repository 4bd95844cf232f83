// SPDX-License-Identifier: Apache-2.0
// Frames of a surface: surfels with their normals, discs, colours and components.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/frames/frame.hpp"
#include "io/image/image.hpp"

namespace thaw {

/// A frame of surfels in the memory of one process. All vectors have one element per surfel.
struct SurfaceFrame {
  double time = 0;  ///< s
  std::int64_t step = 0;
  std::vector<Vec3d> positions;                ///< m
  std::vector<Vec3f> normals;                  ///< unit, outward
  std::vector<float> radii;                    ///< m
  std::vector<Rgb> colours;                    ///< light grey if the file has none
  std::vector<std::uint64_t> ids, components;  ///< 0 if the file has none
  std::vector<FrameColumn> columns;            ///< the other fields: liquid, temperature, detail
  std::string sceneName, sceneText;
  const FrameColumn* find(const std::string& name) const;
};

/// Returns whether a frame has the fields of surfels: `normal` with 3 components and `radius`.
bool isSurfaceFrame(const FrameInfo& info);

/// Error message for frames without surfels.
inline constexpr const char* noSurfaceFrame =
    "is not a frame of a surface: it has no fields normal and radius (frames of surfels are called "
    "NAME_surface_000000.hdf)";

/// Reads a frame of surfels. wanted: selects the other fields; an empty function selects all. Throws IoError
/// as readFrame, and for other frames.
SurfaceFrame readSurfaceFrame(const std::string& path,
                              const std::function<bool(const std::string&)>& wanted = {});

}  // namespace thaw
