// SPDX-License-Identifier: Apache-2.0
// Frames on disk for pictures: search and reading.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "io/render/oriented_view.hpp"
#include "io/render/render_frames.hpp"
#include "io/render/surfels/spray.hpp"
#include "io/surface_mesh/unwrap_component.hpp"

namespace thaw {

/// Frames of a run: of the continuum's particles, of its surface (surfels), of oriented particles or of
/// sheets. Automatic: of the surface if it exists.
enum class FrameKind { Automatic, Particles, Surface, Oriented, Sheet };

/// Returns the frames at `path`, in order of time. `path` is a frame file (.hdf), a series index
/// (.hdf.series), or a folder (a run's folder or its frames/). In a folder the index defines the frames;
/// without an index all .hdf files count, by name. Surface frames whose index is missing count as well.
/// Throws IoError with the path if there are none of this kind.
std::vector<std::filesystem::path> findFrames(const std::filesystem::path& path,
                                              FrameKind kind = FrameKind::Automatic);

/// Returns whether a frame is drawn as a surface: it has surfels or an associated sheet frame.
bool drawnAsSurface(const std::filesystem::path& frame);

/// Returns the sorted names of fields of a frame and of its sheets. Throws IoError with file and cause.
std::vector<std::string> fieldsOf(const std::filesystem::path& frame, bool withSheets = true);

/// ReadFrame for VTKHDF frames. The field "speed" is the length of "velocity". For surfels, "surface" selects
/// their own colours, and "glow" blends them into colours of temperature. Sheets of the same time
/// (NAME_sheet_000120.hdf) are drawn with surfels or particles; particles then become balls of discs.
/// Components across periodic sides are unwrapped (unwrap_component.hpp), unless they join their own image.
/// Throws IoError with file and cause: not HDF5, truncated, not a frame, or unknown field (with the available
/// ones). Drops of surfels are drawn by `spray`; their velocities are those of the surfels or of particles.
/// Particles have the size of the field "volume", if the frame has it.
FrameView readFrameView(const std::filesystem::path& frame, const std::string& field,
                        const PeriodicSides& sides = {}, const SprayStyle& spray = {});

/// Appearance of the contents of a frame.
struct ViewStyle {
  OrientedLook look = OrientedLook::Mesh;
  float spacing = 0;  ///< m, of the particles
  PeriodicSides sides;
  SprayStyle spray;
};

/// Reads the same, and adds oriented particles of the same time in the folder, drawn as discs. A frame
/// of oriented particles is read alone.
FrameView readFullView(const std::filesystem::path& frame, const std::string& field, const ViewStyle& style);

/// Scene text stored in the frame by the run, and its name; empty if there is none.
struct StoredScene {
  std::string name, text;
};
StoredScene storedSceneOf(const std::filesystem::path& frame);

}  // namespace thaw
