// SPDX-License-Identifier: Apache-2.0
// Functions of test extensions on lanes (kernels_isa.cpp).
#pragma once
#include "core/fluid/pair_sums/extension_pair_force.hpp"
#include "core/solid/laws/elastic_law.hpp"

namespace thaw::test {

struct ExtensionKernels {
  LawKernels neoHookean, singleNeoHookean;
  PairForceKernels spring, tension;
};

/// Returns the set of that name, or the best one if it is empty; null for unknown or unsupported names.
const ExtensionKernels* extensionKernels(const char* name = "");

}  // namespace thaw::test
