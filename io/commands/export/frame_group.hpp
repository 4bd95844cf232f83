// SPDX-License-Identifier: Apache-2.0
// Groups of frames at the same time: surface, particles, sheets, oriented bodies.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "io/commands/export/formats.hpp"

namespace thaw {

/// Frame files at one time; a path is empty if the run has no such frame.
struct FrameGroup {
  std::filesystem::path surface, particles, sheets, oriented;
  std::filesystem::path first() const;  ///< the frame that names the output
};

/// Returns the frames of a run or file, grouped by time, for options.what (default:
/// ExportFormat::holdsAllByDefault). Sets `contents` to those of the groups. Throws IoError if there are no
/// such frames, and std::invalid_argument if the format does not support a content.
std::vector<FrameGroup> findFrameGroups(const ExportOptions& options, const ExportFormat& format,
                                        unsigned& contents);

/// Returns the name of an exported frame without extension, such as NAME_surface_000120 or
/// NAME_obstacles_000120 for one content, NAME_all_000120 for several.
std::string outputName(const FrameGroup& group, unsigned contents);

/// Returns the content of a frame file.
unsigned contentOfFrame(const std::filesystem::path& frame);

}  // namespace thaw
