// SPDX-License-Identifier: Apache-2.0
// Conversion to double through memory. As with lanes.hpp, only files compiled per instruction set include
// this.
#pragma once
#include "core/simd/lanes.hpp"

namespace thaw {
namespace THAW_ISA {

/// Equals widen(), but goes through memory, because loads convert directly. In a register, conversion of the
/// upper half needs the shuffle port, which limits the pair and bond loops.
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
