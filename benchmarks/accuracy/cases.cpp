// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {

std::vector<Case> allCases() {
  std::vector<Case> all;
  for (const auto& part : {flowCases(), stretchedCases(), viscousCases(), yieldCases(), tensionCases(),
                           solidCases(), heatCases(), sourceCases(), convectionCases(), meltingCases(),
                           mixedCases(), floatingCases(), tankCases(), surfaceCases()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace thaw::accuracy
