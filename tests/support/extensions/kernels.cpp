// SPDX-License-Identifier: Apache-2.0
#include "tests/support/extensions/kernels.hpp"

#include "core/simd/choose.hpp"

namespace thaw::test {

THAW_CHOOSE(ExtensionKernels, extensionKernelSet, extensionKernels)

}  // namespace thaw::test
