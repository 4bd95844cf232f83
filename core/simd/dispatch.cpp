// SPDX-License-Identifier: Apache-2.0
#include "core/simd/choose.hpp"
#include "core/simd/pair_kernels.hpp"

namespace thaw {

THAW_CHOOSE(PairKernels, pairKernelSet, pairKernels)

}  // namespace thaw
