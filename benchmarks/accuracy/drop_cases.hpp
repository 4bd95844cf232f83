// Drops that surface tension rules. Joined by viscousCases().
#pragma once
#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {

std::vector<Case> dropCases();

}  // namespace thaw::accuracy
