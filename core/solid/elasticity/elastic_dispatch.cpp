// SPDX-License-Identifier: Apache-2.0
#include "core/simd/choose.hpp"
#include "core/solid/elasticity/elastic_kernels.hpp"

namespace thaw {

THAW_CHOOSE(ElasticKernels, elasticKernelSet, elasticKernels)

}  // namespace thaw
