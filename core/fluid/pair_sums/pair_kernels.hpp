// SPDX-License-Identifier: Apache-2.0
// The pair loops, with one set per instruction set. The best set for the processor is chosen at the start.
// All sets give the same bits.
#pragma once
#include <cstdint>

#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/neighbours/search.hpp"

namespace thaw {

struct PairKernels {
  const char* name;  ///< "avx512", "avx2", "base"
  void (*search)(const SearchInput&, Part, SearchBuffers&, NeighbourLists&);
  void (*density)(const PairSums&, GroupRange);
  void (*forces)(const PairSums&, GroupRange);
  void (*tension)(const PairSums&, GroupRange);
  void (*surfaceColours)(const PairSums&, GroupRange);
  void (*surfaceForces)(const PairSums&, GroupRange);
  void (*artificialViscosity)(const PairSums&, GroupRange);
  void (*smoothing)(const PairSums&, GroupRange);
  void (*freeSurfaceIndicator)(const PairSums&, GroupRange);
  void (*closePairs)(const PairSums&, GroupRange, ClosePairs&);
  void (*viscosityCorrection)(const PairSums&, GroupRange);
  void (*viscous)(const PairSums&, const ViscousSums&, GroupRange);
  // Incompressible solver (terms/incompressible.hpp).
  void (*compression)(const PairSums&, GroupRange);
  void (*impulse)(const PairSums&, GroupRange);
  void (*response)(const PairSums&, GroupRange);
};

/// Returns the set of that name, or the best one for this processor if the name is empty. Returns nullptr for
/// unknown or unsupported names.
const PairKernels* pairKernels(const char* name = "");

}  // namespace thaw
