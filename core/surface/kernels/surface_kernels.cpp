// SPDX-License-Identifier: Apache-2.0
#include "core/surface/kernels/surface_kernels.hpp"
#include "core/simd/choose.hpp"

namespace thaw {

THAW_CHOOSE(SurfaceKernels, surfaceKernelSet, surfaceKernels)

const SurfaceKernels& bestSurfaceKernels() {
  static const SurfaceKernels& best = *surfaceKernels();
  return best;
}

}  // namespace thaw
