// Moments of eight slots at once, one set of functions for each instruction set (reference_isa.cpp); every
// set gives the bits of refreshSlot. Where a scene starts all slots ask for theirs. Only plain pointers here,
// as in elastic_kernels.hpp.
#pragma once
#include <cstddef>
#include <cstdint>

#include "core/math/mat3.hpp"

namespace thaw {

/// Bonds that are their other ends (Bonds::vectors is false) and the configuration that they are of.
struct ReferenceArrays {
  const std::uint32_t* neighbour = nullptr;  ///< interleaved by 8 slots as in Bonds
  std::size_t capacity = 0;
  const Vec3d* reference = nullptr;  ///< m, by row
  double support = 0;                ///< m, of bonds
  double period[3]{};                ///< m; 0: not periodic
  double* gathered = nullptr;  ///< 4 x 8 x capacity, aligned to 64 bytes: vectors and weights, which the
                               ///< second function reads again
};

/// Of the eight slots of a group, by [component][lane], components as in Sym3.
struct alignas(64) GroupMoments {
  double moment[6][8], weights[8];  ///< A = sum w X X^T (m^2) and sum w, by `moments`
  double inverse[6][8];             ///< A^-1, for `levers`
  double lengths[8], sum[3][8];     ///< sum |w A^-1 X| and sum w A^-1 X (1/m), by `levers`
};

struct ReferenceKernels {
  const char* name;  ///< as of ElasticKernels
  void (*moments)(const ReferenceArrays&, std::size_t group, GroupMoments&);
  /// after `moments` of the same group
  void (*levers)(const ReferenceArrays&, std::size_t group, GroupMoments&);
};
/// By name, or the best for this processor where the name is empty. Unknown or unsupported names give
/// nullptr.
const ReferenceKernels* referenceKernels(const char* name = "");

}  // namespace thaw
