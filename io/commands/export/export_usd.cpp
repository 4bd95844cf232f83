// SPDX-License-Identifier: Apache-2.0
#include "io/commands/export/write_sequence.hpp"
#include "io/export/usd/usd_scene.hpp"
#include "io/text/version.hpp"

namespace thaw {

namespace fs = std::filesystem;

namespace {

/// Returns the seconds between frames; the scene's interval for one or two frames.
double intervalOf(ExportRun& run) {
  if (run.job.interval > 0) return run.job.interval;
  std::vector<std::string> ignored;
  const auto stored = run.scenes.of(run.groups[0].first(), ignored);
  return stored ? stored->scene.output.every : 0;
}

UsdSequence openSequence(const fs::path& file, const std::string& name, ExportRun& run) {
  const bool isText = run.job.options->as == "usda";
  return {isText ? openUsda(file) : openUsdc(file), name, intervalOf(run)};
}

/// Returns the size of a layer with copies of a frame.
double bytesOfCopies(const fs::path& file, const std::string& name, ExportRun& run, const ExportScene& scene,
                     int copies) {
  const SampleFile sample(file);
  UsdSequence sequence = openSequence(sample.path, name, run);
  UsdFrame frame = usdFrameOf(scene, sequence.file());
  for (int k = 0; k < copies; k++) {
    sequence.add(frame);
    frame.time += intervalOf(run);
  }
  sequence.finish("");
  return sample.bytes();
}

}  // namespace

void writeUsd(const fs::path& file, const std::string& name, ExportRun& run) {
  announceExport(run, allFrames(run), [&](const ExportScene& scene, double frames) {
    const double one = bytesOfCopies(file, name, run, scene, 1),
                 two = bytesOfCopies(file, name, run, scene, 2);
    return one + (frames - 1) * (two - one);
  });
  UsdSequence sequence = openSequence(file, name, run);
  writeSequence(
      file, run, [&](const ExportScene& scene) { return usdFrameOf(scene, sequence.file()); },
      [&](const UsdFrame& frame) { sequence.add(frame); },
      [&] { sequence.finish(fmt::format("thaw {}, scene {}; lengths in metres", versionNumber(), name)); });
}

}  // namespace thaw
