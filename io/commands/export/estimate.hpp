// SPDX-License-Identifier: Apache-2.0
// Expected time and size of an export, from one frame.
#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <system_error>
#include <vector>

#include "io/commands/export/export_frames.hpp"

namespace thaw {

/// Returns the size in bytes of an export of `frames` frames like this scene. It may write a file.
using SampleBytes = std::function<double(const ExportScene& scene, double frames)>;

/// A file that the destructor removes.
struct SampleFile {
  std::filesystem::path path;
  /// beside: the file that the export writes. The sample is in the same folder.
  explicit SampleFile(const std::filesystem::path& beside)
      : path(beside.parent_path() / fmt::format(".{}.sample", beside.filename().string())) {}
  ~SampleFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
  SampleFile(const SampleFile&) = delete;
  SampleFile& operator=(const SampleFile&) = delete;
  double bytes() const { return static_cast<double>(std::filesystem::file_size(path)); }
};

/// Prints the number of frames, and the expected size and time of the export of `todo` (indices of frames).
/// Gathers and writes one frame to measure both. Assumes that size and time of other frames are proportional
/// to their rows. Prints nothing for a single frame.
void announceExport(ExportRun& run, const std::vector<std::size_t>& todo, const SampleBytes& bytesOf);

/// Returns the scene of a frame, which is gathered unless `announceExport` has done so.
ExportScene sceneOf(ExportRun& run, std::size_t frame, GatherNotes& notes);

}  // namespace thaw
