// SPDX-License-Identifier: Apache-2.0
// Speeds of runs as text.
#pragma once
#include <fmt/format.h>

#include <string>

namespace thaw {

/// Returns "1.2 M particle-steps/s", or "85 k particle-steps/s" of a small scene.
inline std::string speedText(double particleStepsPerSecond) {
  return particleStepsPerSecond < 1e6
             ? fmt::format("{:.3g} k particle-steps/s", particleStepsPerSecond / 1e3)
             : fmt::format("{:.3g} M particle-steps/s", particleStepsPerSecond / 1e6);
}

}  // namespace thaw
