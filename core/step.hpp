// One time step: the page to read first.
#pragma once
#include <cstdint>
#include <vector>

#include "core/fluid/records.hpp"
#include "core/halo/halo.hpp"
#include "core/neighbours/search.hpp"
#include "core/neighbours/sort.hpp"
#include "core/simd/pair_kernels.hpp"
#include "core/time/phase_times.hpp"
#include "core/world.hpp"

namespace thaw {

/// The other ranks, seen from the step.
struct Halos {
  Reducer& all;
  CellHalo& cells;
  BondHalo& bonds;
};

/// What a step works in and with; made once, reused in every step.
struct StepTools {
  const PairKernels* kernels = nullptr;
  std::vector<LiquidMaterial> liquids;
  WallTables wallTables;
  SortBuffers sort;
  SearchBuffers search;
  PairRecords records;
  std::vector<std::uint8_t> inner, liquidCells;
  ClosePairs closePairs;
  WallContacts wallContacts;
  PhaseTimes times;
};

}  // namespace thaw
