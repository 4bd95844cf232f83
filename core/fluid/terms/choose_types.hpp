// SPDX-License-Identifier: Apache-2.0
// Dispatch from a scene's kernel and precision to C++ types, for code that is compiled once per instruction
// set.
#pragma once
#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/kernels/kernels.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Calls action(Real{}, Kernel{}).
template<class Action> void chooseTypes(const PairSums& in, Action action) {
  const auto withReal = [&](auto real) {
    switch (in.kernel) {
      case KernelKind::WendlandC2: action(real, WendlandC2{}); break;
      case KernelKind::Mcg03: action(real, Mcg03{}); break;
      case KernelKind::CubicSpline: action(real, CubicSpline{}); break;
    }
  };
  if (in.precision == Precision::Single) withReal(float{});
  else withReal(double{});
}

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
