// Which of the sets of kernels that are compiled once for each instruction set (the *_isa.cpp files) is used:
// chosen at start.
#pragma once
#include <cstring>

namespace thaw {

/// The functions that give the sets; null for what this machine's compiler has no code for.
template<class Kernels> struct KernelSets {
  const Kernels& (*base)();
  const Kernels& (*avx2)();
  const Kernels& (*avx512)();
};

/// That of the name ("base", "avx2", "avx512"), or the best for this processor where the name is empty.
/// Unknown or unsupported names give nullptr.
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

/// Defines `const Kernels* choose(const char* name)` by the functions `give` of all instruction sets.
// clang-format off
#if defined(__x86_64__)
#define THAW_CHOOSE(Kernels, give, choose)                 \
  namespace isa_base { const Kernels& give(); }            \
  namespace isa_avx2 { const Kernels& give(); }            \
  namespace isa_avx512 { const Kernels& give(); }          \
  const Kernels* choose(const char* name) {                \
    return chooseKernels<Kernels>({isa_base::give, isa_avx2::give, isa_avx512::give}, name); \
  }
#else
#define THAW_CHOOSE(Kernels, give, choose)      \
  namespace isa_base { const Kernels& give(); } \
  const Kernels* choose(const char* name) {     \
    return chooseKernels<Kernels>({isa_base::give, nullptr, nullptr}, name); \
  }
#endif
// clang-format on

}  // namespace thaw
