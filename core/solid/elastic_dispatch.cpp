#include <cstring>

#include "core/solid/elastic_kernels.hpp"

namespace thaw {

namespace isa_base { const ElasticKernels& elasticKernelSet(); }
namespace isa_avx2 { const ElasticKernels& elasticKernelSet(); }
namespace isa_avx512 { const ElasticKernels& elasticKernelSet(); }

const ElasticKernels* elasticKernels(const char* name) {
  const bool any = *name == 0;
#if defined(__x86_64__)
  const bool avx2 = __builtin_cpu_supports("avx2"), avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  if (avx512 && (any || std::strcmp(name, "avx512") == 0)) return &isa_avx512::elasticKernelSet();
  if (avx2 && (any || std::strcmp(name, "avx2") == 0)) return &isa_avx2::elasticKernelSet();
#endif
  if (any || std::strcmp(name, "base") == 0) return &isa_base::elasticKernelSet();
  return nullptr;
}

}  // namespace thaw
