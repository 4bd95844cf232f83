// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/pair_sums/pair_kernels.hpp"
#include "core/simd/choose.hpp"

namespace thaw {

THAW_CHOOSE(PairKernels, pairKernelSet, pairKernels)

}  // namespace thaw
