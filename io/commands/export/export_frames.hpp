// SPDX-License-Identifier: Apache-2.0
// Export of many frames, several in parallel.
#pragma once
#include <optional>

#include "io/commands/export/gather_scene.hpp"

namespace thaw {

/// A frame that is gathered before the export starts.
struct FrameSample {
  std::size_t frame = 0;
  ExportScene scene;
  GatherNotes notes;
};

/// Frames of an export, and the data that its threads share.
struct ExportRun {
  std::vector<FrameGroup> groups;
  RunScenes scenes;
  std::optional<SurfaceUv> uv;  ///< texture coordinates of surfels
  GatherJob job;
  int threads = 1;                    ///< frames at a time
  std::optional<FrameSample> sample;  ///< used by the thread of its frame
};

/// Returns export/ in the run folder. The input is that folder, its frames/, or a file in one of them.
std::filesystem::path exportFolder(const std::filesystem::path& input);

/// Finds the frames. Throws IoError and std::invalid_argument.
void startExport(const ExportOptions& options, const ExportFormat& format, ExportRun& run);

/// Prints notes and warnings of a frame.
void printNotes(const GatherNotes& notes);

/// Returns whether a file is complete: it exists and is newer than its frames. Files get their final name
/// when they are complete.
bool isComplete(const std::filesystem::path& file, const std::vector<FrameGroup>& groups);

/// Writes one file per frame. Throws IoError and std::invalid_argument.
void exportFrames(const ExportOptions& options, const ExportFormat& format);

/// Writes a run as one USD layer. out: file, folder, or empty for export/ in the run's folder.
void exportUsd(const std::filesystem::path& out, const ExportOptions& options);

/// Writes the frames of a run as one USD layer. name: name of the root prim. Prints a summary.
void writeUsd(const std::filesystem::path& file, const std::string& name, ExportRun& run);

/// Writes a run as one temporal VTKHDF file. out: as for exportUsd.
void exportVtkHdf(const std::filesystem::path& out, const ExportOptions& options);
void writeVtkHdf(const std::filesystem::path& file, const std::string& name, ExportRun& run);

/// Progress over frames: on a terminal a bar that is redrawn in place, else lines at each tenth if wanted.
class ProgressLine {
 public:
  ProgressLine(std::size_t count, bool wantsLines);
  ~ProgressLine();
  void done(std::size_t frames);
  /// Removes the bar until the next `done`, so that lines can be printed.
  void clear() const;

 private:
  std::size_t count_;
  double start_;
  bool isTerminal_, wantsLines_;
};

}  // namespace thaw
