#include <cstring>

#include "core/simd/pair_kernels.hpp"

namespace thaw {

#define THAW_DECLARE(isa) namespace isa { const PairKernels& pairKernelSet(); }
THAW_DECLARE(isa_base)
THAW_DECLARE(isa_avx2)
THAW_DECLARE(isa_avx512)
#undef THAW_DECLARE

const PairKernels* pairKernels(const char* name) {
  const bool any = *name == 0;
#if defined(__x86_64__)
  const bool avx2 = __builtin_cpu_supports("avx2"), avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  if (avx512 && (any || std::strcmp(name, "avx512") == 0)) return &isa_avx512::pairKernelSet();
  if (avx2 && (any || std::strcmp(name, "avx2") == 0)) return &isa_avx2::pairKernelSet();
#endif
  if (any || std::strcmp(name, "base") == 0) return &isa_base::pairKernelSet();
  return nullptr;
}

}  // namespace thaw
