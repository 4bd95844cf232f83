// SPDX-License-Identifier: Apache-2.0
#include "io/commands/export/write_sequence.hpp"
#include "io/export/vtkhdf_series.hpp"

namespace thaw {

void writeVtkHdf(const std::filesystem::path& file, const std::string&, ExportRun& run) {
  announceExport(run, allFrames(run), [](const ExportScene& scene, double frames) {
    return vtkHdfBytes(vtkHdfFrameOf(scene), frames);
  });
  std::optional<VtkHdfSeries> series;
  writeSequence(
      file, run, [](const ExportScene& scene) { return vtkHdfFrameOf(scene); },
      [&](const VtkHdfFrame& frame) {
        const std::lock_guard lock(run.scenes.hdf5);
        if (!series) series.emplace(file);
        series->add(frame);
      },
      [&] { series->finish(); });
}

}  // namespace thaw
