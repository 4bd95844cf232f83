// SPDX-License-Identifier: Apache-2.0
// Moments of eight solids at once, with one set of functions per instruction set (reference_isa.cpp). All
// sets give the same bits as refreshSolid. At the start of a scene, all solids need their moments. Arrays are
// plain pointers, for the reason given in elastic_kernels.hpp.
#pragma once
#include <cstddef>
#include <cstdint>

#include "core/math/mat3.hpp"

namespace thaw {

/// Bonds without vectors (Bonds::vectors is false) and their common configuration.
struct ReferenceArrays {
  const std::uint32_t* neighbour = nullptr;  ///< interleaved by 8 solids as in Bonds
  std::size_t capacity = 0;
  const Vec3d* reference = nullptr;  ///< m, by row
  double support = 0;                ///< m, upper limit of bond lengths
  double period[3]{};                ///< m; 0: not periodic
  double* gathered = nullptr;  ///< 4 x 8 x capacity, aligned to 64 bytes: vectors and weights that `moments`
                               ///< stores for `levers`
};

/// Results for the eight solids of a group by [component][lane], components as in Sym3.
struct alignas(64) GroupMoments {
  double moment[6][8], weights[8];  ///< A = sum w X X^T (m^2) and sum w, by `moments`
  double inverse[6][8];             ///< A^-1, for `levers`
  double lengths[8], sum[3][8];     ///< sum |w A^-1 X| and sum w A^-1 X (1/m), by `levers`
};

struct ReferenceKernels {
  const char* name;  ///< as ElasticKernels::name
  void (*moments)(const ReferenceArrays&, std::size_t group, GroupMoments&);
  /// Requires: `moments` of the same group was called before.
  void (*levers)(const ReferenceArrays&, std::size_t group, GroupMoments&);
};
/// Returns the set of that name, or the best one for this processor if the name is empty. Returns nullptr for
/// unknown or unsupported names.
const ReferenceKernels* referenceKernels(const char* name = "");

}  // namespace thaw
