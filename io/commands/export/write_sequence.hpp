// SPDX-License-Identifier: Apache-2.0
// Export of a run as one file: frames are made in parallel, and added in order.
#pragma once
#include <fmt/format.h>

#include <numeric>

#include "io/commands/export/estimate.hpp"
#include "io/commands/export/in_order.hpp"
#include "io/text/bytes_text.hpp"

namespace thaw {

/// Returns 0 to count - 1: all frames.
inline std::vector<std::size_t> allFrames(const ExportRun& run) {
  std::vector<std::size_t> all(run.groups.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// Calls add(make(scene)) for the scene of each frame, then finish(), and prints the size of the file. make
/// is called by several threads, add by one at a time.
template<class Make, class Add, class Finish>
void writeSequence(const std::filesystem::path& file, ExportRun& run, Make make, Add add, Finish finish) {
  std::string summary;
  {
    ProgressLine progress(run.groups.size(), true);
    parallelInOrder(
        run.groups.size(), run.threads,
        [&](std::size_t k) {
          GatherNotes notes;
          auto frame = make(sceneOf(run, k, notes));
          return std::pair{std::move(frame), std::move(notes)};
        },
        [&](std::size_t k, auto made) {
          add(made.first);
          progress.clear();
          printNotes(made.second);
          summary = made.second.summary;
          progress.done(k + 1);
        });
  }
  finish();
  const std::size_t frames = run.groups.size();
  fmt::print("{}: {} frame{}, {}; the last has {}\n", file.string(), frames, frames == 1 ? "" : "s",
             bytesText(static_cast<double>(std::filesystem::file_size(file))), summary);
}

}  // namespace thaw
