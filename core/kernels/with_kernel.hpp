// SPDX-License-Identifier: Apache-2.0
// Dispatch from a scene's kernel to its C++ type, for code that is compiled once.
#pragma once
#include "core/kernels/kernels.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Calls action(kernel) with an object of the kernel's type.
template<class Action> auto withKernel(KernelKind kind, Action action) {
  switch (kind) {
    case KernelKind::Mcg03: return action(isa_base::Mcg03{});
    case KernelKind::CubicSpline: return action(isa_base::CubicSpline{});
    default: return action(isa_base::WendlandC2{});
  }
}

}  // namespace thaw
