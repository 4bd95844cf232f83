// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "io/commands/export/export_frames.hpp"
#include "io/commands/export/in_order.hpp"
#include "io/export/vtkhdf_series.hpp"
#include "io/text/bytes_text.hpp"

namespace thaw {

namespace fs = std::filesystem;

void writeVtkHdf(const fs::path& file, const std::string&, ExportRun& run) {
  std::optional<VtkHdfSeries> series;
  struct Made {
    VtkHdfFrame frame;
    GatherNotes notes;
  };
  std::string summary;
  {
    ProgressLine progress(run.groups.size());
    parallelInOrder(
        run.groups.size(), run.threads,
        [&](std::size_t k) {
          Made made;
          made.frame = vtkHdfFrameOf(gatherScene(run.groups[k], run.job, made.notes));
          return made;
        },
        [&](std::size_t k, Made made) {
          {
            const std::lock_guard lock(run.scenes.hdf5);
            if (!series) series.emplace(file);
            series->add(made.frame);
          }
          printNotes(made.notes);
          summary = made.notes.summary;
          progress.done(k + 1);
        });
  }
  series->finish();
  const std::size_t frames = run.groups.size();
  fmt::print("{}: {} frame{}, {}; the last has {}\n", file.string(), frames, frames == 1 ? "" : "s",
             bytesText(static_cast<double>(fs::file_size(file))), summary);
}

}  // namespace thaw
