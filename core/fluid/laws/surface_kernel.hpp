// SPDX-License-Identifier: Apache-2.0
// Kernel of the surface energy. Code that is compiled per instruction set includes this only through the
// namespace of lanes.hpp.
#pragma once
#include "core/kernels/kernels.hpp"

namespace thaw {
namespace THAW_ISA {

/// W = 315 / (64 pi) (1 - q^2)^3, independent of the scene's kernel. Its slope gives second neighbours almost
/// the same weight as first neighbours. The surface energy thus depends little on the arrangement of
/// particles. grad W = slope d; the Hessian is slope 1 + secondDerivative d d.
struct SurfaceKernel {
  template<class T> static THAW_INLINE T w(T q2) {
    const T u = max(T(1.0) - q2, T(0.0));
    return T(315 / (64 * pi)) * (u * u * u);
  }
  template<class T> static THAW_INLINE T slope(T q2) {
    const T u = max(T(1.0) - q2, T(0.0));
    return T(-945 / (32 * pi)) * (u * u);
  }
  template<class T> static THAW_INLINE T secondDerivative(T q2) {
    return T(945 / (8 * pi)) * max(T(1.0) - q2, T(0.0));
  }
};

}  // namespace THAW_ISA
}  // namespace thaw
