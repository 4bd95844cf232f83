// SPDX-License-Identifier: Apache-2.0
// Work data of the sums over neighbour pairs, reused in each step. They are not part of the state.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/fluid/pair_sums/pair_kernels.hpp"
#include "core/fluid/pair_sums/records.hpp"
#include "core/kernels/sum_scales.hpp"
#include "core/neighbours/search.hpp"

namespace thaw {

struct PairSumWork {
  const PairKernels* kernels = nullptr;
  SumScales scales;
  double artificialViscosity = 0;  ///< Pa s, of the liquid of a scene of one liquid (Modules::uniform)
  SearchBuffers search;
  PairRecords records;
  std::vector<std::uint8_t> inner;        ///< by cell: 1 if its sums need no ghosts
  std::vector<std::uint8_t> liquidCells;  ///< by cell: 1 if it contains liquid; unused in scenes of liquids
  std::size_t ghostRoom = 1024;  ///< rows reserved for ghosts between the owned rows and the dummy row
};

}  // namespace thaw
