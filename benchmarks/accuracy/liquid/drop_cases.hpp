// SPDX-License-Identifier: Apache-2.0
// Drops under surface tension. viscousCases() includes these cases.
#pragma once
#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {

std::vector<Case> dropCases();

}  // namespace thaw::accuracy
