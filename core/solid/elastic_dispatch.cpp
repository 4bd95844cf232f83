#include "core/simd/choose.hpp"
#include "core/solid/elastic_kernels.hpp"

namespace thaw {

THAW_CHOOSE(ElasticKernels, elasticKernelSet, elasticKernels)

}  // namespace thaw
