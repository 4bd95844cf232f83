// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/data/relax_progress.hpp"

#include <cmath>

namespace thaw {
namespace {

constexpr double less = 0.9, more = 1.02;        // ratios of force, and of number of particles, to their
                                                 // values at the last gain
constexpr double fewest = 1000, perLength = 20;  // iterations; iterations per particle along the surface

}  // namespace

std::int64_t relaxStallLimit(std::int64_t particles) {
  return static_cast<std::int64_t>(fewest + perLength * std::sqrt(static_cast<double>(particles)));
}

bool makesProgress(RelaxProgress& p, std::int64_t done, double force, std::int64_t particles) {
  // after growth of the surface, the smallest force is reset
  if (static_cast<double>(particles) > more * static_cast<double>(p.most)) {
    p = {force, particles, done};
  } else if (force < less * p.least) {
    p.least = force;
    p.gained = done;
  }
  return done - p.gained < relaxStallLimit(p.most);
}

}  // namespace thaw
