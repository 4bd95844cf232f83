// SPDX-License-Identifier: Apache-2.0
// Run-time choice between kernel sets compiled for several instruction sets (the *_isa.cpp files).
#pragma once
#include <cstring>

namespace thaw {

/// Functions that return the kernel sets; null if the compiler does not target the instruction set.
template<class Kernels> struct KernelSets {
  const Kernels& (*base)();
  const Kernels& (*avx2)();
  const Kernels& (*avx512)();
};

/// Returns the kernel set with this name ("base", "avx2", "avx512"). For an empty name, returns the best set
/// for this processor. Returns nullptr for unknown or unsupported names.
template<class Kernels> const Kernels* chooseKernels(const KernelSets<Kernels>& sets, const char* name) {
  const bool any = *name == 0;
#if defined(__x86_64__)
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi2"),
             avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512bw");
  if (avx512 && (any || std::strcmp(name, "avx512") == 0)) return &sets.avx512();
  if (avx2 && (any || std::strcmp(name, "avx2") == 0)) return &sets.avx2();
#endif
  return any || std::strcmp(name, "base") == 0 ? &sets.base() : nullptr;
}

/// Defines `const Kernels* choose(const char* name)` from the functions `give` of all instruction sets.
// clang-format off
#if defined(__x86_64__)
#define THAW_CHOOSE(Kernels, give, choose)                 \
  namespace isa_base { const Kernels& give(); }            \
  namespace isa_avx2 { const Kernels& give(); }            \
  namespace isa_avx512 { const Kernels& give(); }          \
  const Kernels* choose(const char* name) {                \
    return ::thaw::chooseKernels<Kernels>({isa_base::give, isa_avx2::give, isa_avx512::give}, name); \
  }
#else
#define THAW_CHOOSE(Kernels, give, choose)      \
  namespace isa_base { const Kernels& give(); } \
  const Kernels* choose(const char* name) {     \
    return ::thaw::chooseKernels<Kernels>({isa_base::give, nullptr, nullptr}, name); \
  }
#endif
// clang-format on

}  // namespace thaw
