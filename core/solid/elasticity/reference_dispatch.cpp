// SPDX-License-Identifier: Apache-2.0
#include "core/simd/choose.hpp"
#include "core/solid/elasticity/reference_kernels.hpp"

namespace thaw {

THAW_CHOOSE(ReferenceKernels, referenceKernelSet, referenceKernels)

}  // namespace thaw
