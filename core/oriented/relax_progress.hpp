// Does a relaxation in which particles come and go still get anywhere?
#pragma once
#include <cstdint>

#include "core/scene/shape.hpp"

namespace thaw {

/// What a relaxation has come to so far: the same on all ranks, if its figures are.
struct RelaxProgress {
  double least = never;     ///< force over stiffness times spacing, since there were as many particles as now
  std::int64_t most = 0;    ///< particles
  std::int64_t gained = 0;  ///< iteration at which one of the two was better by as much as counts
};

/// Iterations without a gain after which none is to be expected: a disturbance crosses a surface of so many
/// particles in some multiple of their number along it.
std::int64_t relaxPatience(std::int64_t particles);

/// Notes what iteration `done` has found, and says whether to go on: false after relaxPatience without the
/// largest force having become less by a tenth and without the surface having grown by a fiftieth. So there
/// is an end for any number of particles that is bounded: each size has some 200 tenths to go to 1e-9.
bool getsAnywhere(RelaxProgress& progress, std::int64_t done, double force, std::int64_t particles);

}  // namespace thaw
