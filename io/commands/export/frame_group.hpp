// SPDX-License-Identifier: Apache-2.0
// Frames of one time: of a surface, of particles, of sheets and of oriented bodies.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "io/commands/export/formats.hpp"

namespace thaw {

/// Files of one time; empty where a run has none.
struct FrameGroup {
  std::filesystem::path surface, particles, sheets, oriented;
  std::filesystem::path first() const;  ///< the frame that names the output
};

/// Returns the frames of a run or file by time, with the contents `wanted`; 0: see
/// ExportFormat::holdsAllByDefault. `contents` is set to what the groups hold. Throws IoError without frames
/// of a wanted kind, and std::invalid_argument if the format cannot hold it.
std::vector<FrameGroup> findFrameGroups(const ExportOptions& options, const ExportFormat& format,
                                        unsigned& contents);

/// Returns the name of an exported frame without its ending: that of its frame for one content, such as
/// NAME_surface_000120, NAME_obstacles_000120, or NAME_all_000120 for several contents.
std::string outputName(const FrameGroup& group, unsigned contents);

/// Returns the content of a frame file.
unsigned contentOfFrame(const std::filesystem::path& frame);

}  // namespace thaw
