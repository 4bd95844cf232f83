// Conversion to double by way of memory. Included from code of one instruction set only, as lanes.hpp.
#pragma once
#include "core/simd/lanes.hpp"

namespace thaw {
namespace THAW_ISA {

/// widen(), but from memory: loads convert by themselves, where converting the upper half of a register takes
/// the one port for shuffles, which the loops over pairs and bonds have too much to do for. (Of a liquid's
/// forces: 85 -> 58 ns a particle on a Xeon.)
THAW_INLINE LanesD wide(LanesF a) {
#if defined(__AVX__)
  alignas(32) float at[8];
  __builtin_memcpy(at, &a, 32);
  asm("" : "+m"(at));
  return {reinterpret_cast<Vec4d>(_mm256_cvtps_pd(_mm_load_ps(at))),
          reinterpret_cast<Vec4d>(_mm256_cvtps_pd(_mm_load_ps(at + 4)))};
#else
  return widen(a);
#endif
}
THAW_INLINE LanesD wide(LanesD a) { return a; }

}  // namespace THAW_ISA
}  // namespace thaw
