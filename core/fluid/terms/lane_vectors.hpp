// SPDX-License-Identifier: Apache-2.0
// Vectors and tensors of eight lanes.
#pragma once
#include "core/simd/lanes.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

template<class L> struct Vector3 { L x = L(0.0), y = L(0.0), z = L(0.0); };
template<class L> THAW_INLINE Vector3<L> scaled(L k, const Vector3<L>& v) {
  return {k * v.x, k * v.y, k * v.z};
}
template<class L> THAW_INLINE L dotOf(const Vector3<L>& a, const Vector3<L>& b) {
  return dot3(a.x, a.y, a.z, b.x, b.y, b.z);
}
/// Adds factor (x, y, z).
template<class L> THAW_INLINE void addScaled(Vector3<L>& to, L factor, L x, L y, L z) {
  to.x = fma(factor, x, to.x);
  to.y = fma(factor, y, to.y);
  to.z = fma(factor, z, to.z);
}
/// Components XX YY ZZ XY YZ XZ, the order of Sym3.
template<class L> struct Tensor {
  L xx = L(0.0), yy = L(0.0), zz = L(0.0), xy = L(0.0), yz = L(0.0), xz = L(0.0);
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
