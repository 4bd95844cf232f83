// What a term of the pair sums is: `load` of a group of eight rows, `pair` of own row and neighbour in each lane, and `finish`, which writes
// the sums of eight rows. The loop is sweep(). Compiled once for each instruction set.
// d: position difference own - other in support radii; V: volumes in h^3; lengths come back with the factors in finish.
#pragma once
#include "core/kernels/kernels.hpp"
#include "core/neighbours/sweep.hpp"
#include "core/simd/pair_kernels.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

template<class Real> const Record<Real>* records(const void* p) { return static_cast<const Record<Real>*>(p); }
/// widen() by way of memory: loads convert by themselves, where a conversion of the upper half of a register takes the one port for shuffles, which
/// the loops over pairs have too much to do for.
THAW_INLINE LanesD wide(LanesF a) {
#if defined(__AVX__)
  alignas(32) float at[8];
  __builtin_memcpy(at, &a, 32);
  asm("" : "+m"(at));
  return {reinterpret_cast<Vec4d>(_mm256_cvtps_pd(_mm_load_ps(at))), reinterpret_cast<Vec4d>(_mm256_cvtps_pd(_mm_load_ps(at + 4)))};
#else
  return widen(a);
#endif
}
THAW_INLINE LanesD wide(LanesD a) { return a; }
template<class L> THAW_INLINE L square(L a) { return a * a; }

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
