// SPDX-License-Identifier: Apache-2.0
// Times at which the heat sources of a scene are on.
#pragma once
#include <algorithm>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns the fraction (1) of the step [begin, end] (s) in which a source is on. For a step of length 0, it
/// is 1 if the source is on at `begin`, else 0.
inline double shareOn(double start, double stop, double begin, double end) {
  if (!(end > begin)) return start <= begin && begin < stop;
  return std::max(0.0, std::min(stop, end) - std::max(start, begin)) / (end - begin);
}

/// Returns true if a lamp, laser or heated region is on at any time in [begin, end] (s).
inline bool anySourceOn(const Scene& s, double begin, double end) {
  const auto on = [&](const auto& source) { return shareOn(source.start, source.end, begin, end) > 0; };
  return std::ranges::any_of(s.lamps, on) || std::ranges::any_of(s.lasers, on) ||
         std::ranges::any_of(s.heatedRegions, on);
}

}  // namespace thaw
