#include "core/simd/choose.hpp"
#include "core/surface/surface_kernels.hpp"

namespace thaw {

THAW_CHOOSE(SurfaceKernels, surfaceKernelSet, surfaceKernels)

const SurfaceKernels& bestSurfaceKernels() {
  static const SurfaceKernels& best = *surfaceKernels();
  return best;
}

}  // namespace thaw
