// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include <fmt/format.h>

#include "io/commands/export/export_frames.hpp"
#include "io/text/duration_text.hpp"

namespace thaw {

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ProgressLine::ProgressLine(std::size_t count)
    : count_(count), start_(now()), isTerminal_(count > 1 && isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (isTerminal_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressLine::done(std::size_t frames) {
  if (!isTerminal_) return;
  const double left = (now() - start_) / static_cast<double>(frames) * static_cast<double>(count_ - frames);
  fmt::print(stderr, "\r\x1b[K{} of {} frames, {} left\r", frames, count_, durationText(left));
  std::fflush(stderr);
}

}  // namespace thaw
