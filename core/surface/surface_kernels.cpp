#include <cstring>

#include "core/surface/surface_kernels.hpp"

namespace thaw {

namespace isa_base { const SurfaceKernels& surfaceKernelSet(); }
namespace isa_avx2 { const SurfaceKernels& surfaceKernelSet(); }
namespace isa_avx512 { const SurfaceKernels& surfaceKernelSet(); }

const SurfaceKernels* surfaceKernels(const char* name) {
  const bool any = *name == 0;
#if defined(__x86_64__)
  const bool avx2 = __builtin_cpu_supports("avx2"), avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  if (avx512 && (any || std::strcmp(name, "avx512") == 0)) return &isa_avx512::surfaceKernelSet();
  if (avx2 && (any || std::strcmp(name, "avx2") == 0)) return &isa_avx2::surfaceKernelSet();
#endif
  if (any || std::strcmp(name, "base") == 0) return &isa_base::surfaceKernelSet();
  return nullptr;
}

}  // namespace thaw
