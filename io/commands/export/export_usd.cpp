// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "io/commands/export/export_frames.hpp"
#include "io/commands/export/in_order.hpp"
#include "io/export/usd/usd_scene.hpp"
#include "io/text/bytes_text.hpp"
#include "io/text/version.hpp"

namespace thaw {

namespace fs = std::filesystem;

void writeUsd(const fs::path& file, const std::string& name, ExportRun& run) {
  double interval = run.job.interval;
  if (interval <= 0) {  // one or two frames: the scene's interval
    std::vector<std::string> ignored;
    if (const auto stored = run.scenes.of(run.groups[0].first(), ignored))
      interval = stored->scene.output.every;
  }
  const bool isText = run.job.options->as == "usda";
  UsdSequence sequence(isText ? openUsda(file) : openUsdc(file), name, interval);
  struct Made {
    UsdFrame frame;
    GatherNotes notes;
  };
  std::string summary;
  {
    ProgressLine progress(run.groups.size());
    parallelInOrder(
        run.groups.size(), run.threads,
        [&](std::size_t k) {
          Made made;
          made.frame = usdFrameOf(gatherScene(run.groups[k], run.job, made.notes), sequence.file());
          return made;
        },
        [&](std::size_t k, Made made) {
          sequence.add(made.frame);
          printNotes(made.notes);
          summary = made.notes.summary;
          progress.done(k + 1);
        });
  }
  sequence.finish(fmt::format("thaw {}, scene {}; lengths in metres", versionNumber(), name));
  const std::size_t frames = run.groups.size();
  fmt::print("{}: {} frame{}, {}; the last has {}\n", file.string(), frames, frames == 1 ? "" : "s",
             bytesText(static_cast<double>(fs::file_size(file))), summary);
}

}  // namespace thaw
