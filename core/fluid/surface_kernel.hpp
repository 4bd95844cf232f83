// The kernel of the surface energy. Include from code of one instruction set only through lanes.hpp's
// namespace.
#pragma once
#include "core/kernels/kernels.hpp"

namespace thaw {
namespace THAW_ISA {

/// W = 315 / (64 pi) (1 - q^2)^3, whatever the kernel of the scene is: its slope counts the second neighbours
/// almost like the first, so that the energy of a surface depends little on how its particles lie. grad W =
/// slope d; the Hessian is slope 1 + bend d d.
struct SurfaceKernel {
  template<class T> static THAW_INLINE T w(T q2) {
    const T u = max(T(1.0) - q2, T(0.0));
    return T(315 / (64 * pi)) * (u * u * u);
  }
  template<class T> static THAW_INLINE T slope(T q2) {
    const T u = max(T(1.0) - q2, T(0.0));
    return T(-945 / (32 * pi)) * (u * u);
  }
  template<class T> static THAW_INLINE T bend(T q2) { return T(945 / (8 * pi)) * max(T(1.0) - q2, T(0.0)); }
};

}  // namespace THAW_ISA
}  // namespace thaw
