// SPDX-License-Identifier: Apache-2.0
// The surface (K05 section 4) against exact shapes and motions: surfels at rest, and surfels that move, split
// and merge.
#include "benchmarks/accuracy/surface/surface_trials.hpp"

namespace thaw::accuracy {

std::vector<Case> surfaceCases() {
  std::vector<Case> all = restingSurfaceCases();
  for (const Case& c : movingSurfaceCases()) all.push_back(c);
  return all;
}

}  // namespace thaw::accuracy
