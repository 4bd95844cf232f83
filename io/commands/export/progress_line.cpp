// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "core/time/seconds_now.hpp"
#include "io/commands/export/export_frames.hpp"
#include "io/text/duration_text.hpp"
#include "io/text/progress_bar.hpp"

namespace thaw {

ProgressLine::ProgressLine(std::size_t count, bool wantsLines)
    : count_(count), start_(secondsNow()), isTerminal_(false), wantsLines_(wantsLines && count > 1) {
  const char* term = std::getenv("TERM");
  isTerminal_ = count > 1 && isatty(STDERR_FILENO) == 1 && term && std::string(term) != "dumb";
}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() const {
  if (isTerminal_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressLine::done(std::size_t frames) {
  const double left = (secondsNow() - start_) / static_cast<double>(frames) *
                      static_cast<double>(count_ - frames),
               share = static_cast<double>(frames) / static_cast<double>(count_);
  const std::string counts = fmt::format("{} of {} frames", frames, count_);
  if (isTerminal_) {
    std::fflush(stdout);
    fmt::print(stderr, "\r{} {:3.0f} %  left {}  {}\x1b[K", progressBar(share, 22), 100 * share,
               durationText(left), counts);
    std::fflush(stderr);
  } else if (wantsLines_ && frames * 10 / count_ > (frames - 1) * 10 / count_) {
    fmt::print("{}, left {}\n", counts, durationText(left));
    std::fflush(stdout);
  }
}

}  // namespace thaw
