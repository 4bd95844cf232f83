// SPDX-License-Identifier: Apache-2.0
#include "io/commands/export/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/time/seconds_now.hpp"
#include "io/text/bytes_text.hpp"
#include "io/text/duration_text.hpp"

namespace thaw {

namespace {

/// Size of a particle, divided by that of a surfel with its triangles.
constexpr double particleShare = 0.25;

double rowsOf(const FrameGroup& group, unsigned contents) {
  double rows = 0;
  for (const auto& [content, file] :
       {std::pair{surfaceContent, group.surface}, std::pair{sheetContent, group.sheets},
        std::pair{orientedContent, group.oriented}, std::pair{particleContent, group.particles}})
    if ((contents & content) && !file.empty())
      rows += (content == surfaceContent ? 1 : particleShare) *
              static_cast<double>(readFrameInfo(file.string()).count);
  return rows;
}

/// The frame to measure, and the cost of the whole export in units of this frame.
struct Sampling {
  std::size_t frame;
  double frames;
};

/// Chooses the first frame unless it is much smaller than others.
Sampling samplingOf(const ExportRun& run, const std::vector<std::size_t>& todo) {
  constexpr std::size_t most = 17;
  const std::size_t count = std::min(most, todo.size());
  double sum = 0, first = 0;
  Sampling largest{todo.front(), 0};
  for (std::size_t k = 0; k < count; k++) {
    const std::size_t frame = todo[count == 1 ? 0 : k * (todo.size() - 1) / (count - 1)];
    const double rows = rowsOf(run.groups[frame], run.job.contents);
    sum += rows;
    if (k == 0) first = rows;
    if (rows > largest.frames) largest = {frame, rows};
  }
  const bool isSmall = 2 * first < largest.frames;
  const double measured = isSmall ? largest.frames : first;
  return {
      isSmall ? largest.frame : todo.front(),
      static_cast<double>(todo.size()) * (measured > 0 ? sum / static_cast<double>(count) / measured : 1)};
}

}  // namespace

void announceExport(ExportRun& run, const std::vector<std::size_t>& todo, const SampleBytes& bytesOf) {
  if (run.groups.size() < 2 || todo.empty()) return;
  const Sampling sampling = samplingOf(run, todo);
  const double start = secondsNow();
  FrameSample sample{sampling.frame, {}, {}};
  sample.scene = gatherScene(run.groups[sampling.frame], run.job, sample.notes);
  const double bytes = bytesOf(sample.scene, sampling.frames),
               seconds = (secondsNow() - start) * sampling.frames / run.threads;
  run.sample = std::move(sample);
  fmt::print("{} frames as {}, about {} and {}\n", todo.size(), run.job.format->name, bytesText(bytes),
             durationText(seconds));
  std::fflush(stdout);
}

ExportScene sceneOf(ExportRun& run, std::size_t frame, GatherNotes& notes) {
  if (run.sample && run.sample->frame == frame) {
    notes = std::move(run.sample->notes);
    return std::move(run.sample->scene);
  }
  return gatherScene(run.groups[frame], run.job, notes);
}

}  // namespace thaw
