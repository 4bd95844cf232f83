// SPDX-License-Identifier: Apache-2.0
#include "io/commands/export/export_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include "io/commands/export/estimate.hpp"
#include "io/commands/export/in_order.hpp"
#include "io/commands/export/out_name.hpp"
#include "io/hdf5/make_folder.hpp"
#include "io/meshes/read_mesh.hpp"
#include "io/render/frame_source.hpp"

namespace thaw {

namespace fs = std::filesystem;

namespace {

/// Returns the mean time between frames (s) without the last one; 0 for fewer than three frames.
double intervalOf(const std::vector<FrameGroup>& groups) {
  if (groups.size() < 3) return 0;  // the last frame may come early, at the end of the run
  const std::size_t last = groups.size() - 2;
  const double from = readFrameInfo(groups[0].first().string()).time,
               to = readFrameInfo(groups[last].first().string()).time;
  return (to - from) / static_cast<double>(last);
}

/// Returns the surface frames from the start of the run to the last one of the export.
std::vector<fs::path> surfacesUpTo(const std::vector<FrameGroup>& groups) {
  std::vector<fs::path> frames;
  try {
    frames = findFrames(groups.back().surface.parent_path(), FrameKind::Surface);
  } catch (const IoError&) {  // frames of several runs in one folder
  }
  const auto last = std::find(frames.begin(), frames.end(), groups.back().surface);
  if (last != frames.end()) {
    frames.erase(last + 1, frames.end());
    return frames;
  }
  frames.clear();
  for (const FrameGroup& group : groups) frames.push_back(group.surface);
  return frames;
}

/// Finds the texture coordinates of surfels.
void startUv(ExportRun& run) {
  if (!(run.job.contents & surfaceContent) || run.groups.back().surface.empty())
    throw std::invalid_argument("--uv applies to frames of a surface; add surface to --what");
  std::vector<std::string> warnings;
  const auto stored = run.scenes.of(run.groups[0].first(), warnings);
  for (const std::string& line : warnings) fmt::print(stderr, "thaw export: {}\n", line);
  if (!stored) throw std::invalid_argument("--uv: the frames contain no scene, so the meshes are unknown");
  try {
    run.uv = followUv(stored->scene, surfacesUpTo(run.groups));
  } catch (const MeshError& error) { throw std::invalid_argument(std::string("--uv: ") + error.what()); }
  if (run.uv->empty())
    fmt::print(stderr, "thaw export: warning: --uv: no body has a mesh with texture coordinates\n");
  else run.job.uv = &*run.uv;
}

/// Returns the part of a format's ending that is the extension of a path: ".ply" of ".discs.ply".
std::string lastEnding(const ExportFormat& format) {
  const std::string ending = format.extension;
  return ending.substr(ending.rfind('.'));
}

/// Refuses an `--out` that is neither a folder nor, for one frame, a file of the format.
void checkOut(const fs::path& out, const ExportFormat& format, std::size_t frames) {
  if (out.empty() || isFolder(out)) return;
  const std::string ending = out.extension().string();
  if (frames == 1) {
    if (ending.empty() || ending == lastEnding(format)) return;
    refuseOut(out, lastEnding(format));
  }
  const auto isOf = [&](const ExportFormat& f) { return ending == lastEnding(f); };
  std::error_code error;
  if (fs::exists(out, error) || ending == ".usd" || std::ranges::any_of(exportFormats(), isOf))
    throw std::invalid_argument(
        fmt::format("--out: --as {} writes a file for each of {} frames: expected a "
                    "folder, got {}",
                    format.name, frames, out.string()));
}

}  // namespace

fs::path exportFolder(const fs::path& input) {
  fs::path folder = fs::is_directory(input) ? input : input.parent_path();
  if (folder.filename().empty() && folder.has_parent_path()) folder = folder.parent_path();  // "run/"
  if (folder.filename() == "frames") folder = folder.parent_path();
  return folder / "export";
}

void printNotes(const GatherNotes& notes) {
  for (const std::string& note : notes.notes) fmt::print("{}\n", note);
  for (const std::string& warning : notes.warnings) fmt::print(stderr, "thaw export: {}\n", warning);
}

bool isComplete(const fs::path& file, const std::vector<FrameGroup>& groups) {
  std::error_code error;
  const auto made = fs::last_write_time(file, error);
  if (error) return false;
  for (const FrameGroup& group : groups)
    for (const fs::path* frame : {&group.surface, &group.particles, &group.sheets, &group.oriented})
      if (!frame->empty() && fs::last_write_time(*frame, error) > made) return false;
  return true;
}

void startExport(const ExportOptions& options, const ExportFormat& format, ExportRun& run) {
  run.job.options = &options;
  run.job.format = &format;
  run.job.scenes = &run.scenes;
  run.groups = findFrameGroups(options, format, run.job.contents);
  constexpr unsigned coloured = surfaceContent | particleContent;
  if (!(run.job.contents & coloured) && options.field != "surface")
    throw std::invalid_argument(
        "sheets and oriented particles are exported in their own colours, --as vtp with all fields: expected "
        "no --field, got " +
        options.field);
  const int cores = options.threads > 0 ? options.threads
                                        : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  run.threads = static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(cores), run.groups.size()));
  run.job.threads = run.groups.size() == 1 ? cores : 1;
  run.job.interval = intervalOf(run.groups);
  if (options.uv) startUv(run);
}

void exportFrames(const ExportOptions& options, const ExportFormat& format) {
  ExportRun run;
  startExport(options, format, run);
  checkOut(options.out, format, run.groups.size());
  const bool one = run.groups.size() == 1 && !isFolder(options.out) && options.out.has_extension();
  const fs::path folder = options.out.empty() ? exportFolder(options.input) : options.out;
  std::vector<fs::path> files;
  for (const FrameGroup& group : run.groups)
    files.push_back(one ? options.out : folder / (outputName(group, run.job.contents) + format.extension));
  makeFolder(files[0].parent_path());
  std::vector<std::size_t> todo;
  for (std::size_t k = 0; k < files.size(); k++)
    if (!options.resume || !isComplete(files[k], {run.groups[k]})) todo.push_back(k);
  if (todo.size() < files.size()) fmt::print("{} complete files are kept\n", files.size() - todo.size());
  announceExport(run, todo, [&](const ExportScene& scene, double frames) {
    const SampleFile sample(files[todo[0]]);
    format.writeFrame(sample.path, scene);
    return frames * sample.bytes();
  });
  ProgressLine progress(todo.size(), false);
  parallelInOrder(
      todo.size(), run.threads,
      [&](std::size_t k) {
        GatherNotes notes;
        format.writeFrame(files[todo[k]], sceneOf(run, todo[k], notes));
        return notes;
      },
      [&](std::size_t k, const GatherNotes& notes) {
        progress.clear();
        printNotes(notes);
        fmt::print("{}: {}\n", files[todo[k]].string(), notes.summary);
        progress.done(k + 1);
      });
}

namespace {

/// Writes a run as one file. other: an ending that --out may have, too.
void exportAsOne(const fs::path& out, const ExportOptions& options, const char* other,
                 void write(const fs::path& file, const std::string& name, ExportRun& run)) {
  const ExportFormat& format = exportFormatNamed(options.as);
  const std::string ending = isFolder(out) ? "" : out.extension().string();
  if (!ending.empty() && ending != format.extension && ending != other)
    refuseOut(out, fmt::format("{} or {}", format.extension, other));
  ExportRun run;
  startExport(options, format, run);
  std::string name = readFrameInfo(run.groups[0].first().string()).sceneName;
  if (name.empty()) name = "run";
  const fs::path folder = out.empty() ? exportFolder(options.input) : out;
  const fs::path file = !ending.empty() ? out : folder / (name + format.extension);
  if (options.resume && isComplete(file, run.groups)) {
    fmt::print("{} is complete and kept\n", file.string());
    return;
  }
  makeFolder(file.parent_path());
  write(file, name, run);
}

}  // namespace

void exportUsd(const fs::path& out, const ExportOptions& options) {
  exportAsOne(out, options, ".usd", writeUsd);
}

void exportVtkHdf(const fs::path& out, const ExportOptions& options) {
  exportAsOne(out, options, ".hdf", writeVtkHdf);
}

}  // namespace thaw
