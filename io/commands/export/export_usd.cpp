// SPDX-License-Identifier: Apache-2.0
#include "io/commands/export/write_sequence.hpp"
#include "io/export/usd/usd_scene.hpp"
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
  writeSequence(
      file, run, [&](const ExportScene& scene) { return usdFrameOf(scene, sequence.file()); },
      [&](const UsdFrame& frame) { sequence.add(frame); },
      [&] { sequence.finish(fmt::format("thaw {}, scene {}; lengths in metres", versionNumber(), name)); });
}

}  // namespace thaw
