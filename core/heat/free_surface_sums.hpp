// SPDX-License-Identifier: Apache-2.0
// Pair sums of heat at free surfaces, compiled once per instruction set (free_surface_sums_isa.cpp).
#pragma once
#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/heat/exposed_area.hpp"

namespace thaw {

/// Sums over the neighbours of a particle with the weights V lap W of conduction; lengths in support radii.
struct ConductionSums {
  float weight = -1;  ///< sum of the weights; negative: not summed
  Sym3f moment;       ///< weights times d d
};

struct FreeSurfaceKernels {
  const char* name;  ///< "avx512", "avx2", "base"
  /// Sets the areas of exposed_area.hpp, before walls.
  void (*areas)(const PairSums&, const ExposedAreaLaw&, float* area, GroupRange);
  /// Sets the sums of conduction_correction.hpp, before walls.
  void (*conduction)(const PairSums&, ConductionSums* sums, GroupRange);
};

/// Returns the set of that name, or the best one for this processor if the name is empty. Returns nullptr for
/// unknown or unsupported names.
const FreeSurfaceKernels* freeSurfaceKernels(const char* name = "");

}  // namespace thaw
