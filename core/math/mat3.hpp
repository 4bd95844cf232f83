// SPDX-License-Identifier: Apache-2.0
// 3x3 matrices (row major) and symmetric 3x3 tensors (XX YY ZZ XY YZ XZ, the order of VTK).
#pragma once
#include "core/math/vec3.hpp"

namespace thaw {

template<class T> struct Mat3 { Vec3<T> row[3]; };
template<class T> struct Sym3 { T xx{}, yy{}, zz{}, xy{}, yz{}, xz{}; };
using Mat3d = Mat3<double>;
using Mat3f = Mat3<float>;
using Sym3d = Sym3<double>;
using Sym3f = Sym3<float>;

template<class T> Mat3<T> identity3() {
  return {{{T(1), T(0), T(0)}, {T(0), T(1), T(0)}, {T(0), T(0), T(1)}}};
}
template<class T> Mat3<T> operator+(const Mat3<T>& a, const Mat3<T>& b) {
  return {{a.row[0] + b.row[0], a.row[1] + b.row[1], a.row[2] + b.row[2]}};
}
template<class T> Mat3<T> operator-(const Mat3<T>& a, const Mat3<T>& b) {
  return {{a.row[0] - b.row[0], a.row[1] - b.row[1], a.row[2] - b.row[2]}};
}
template<class T> Mat3<T> operator*(const T& s, const Mat3<T>& a) {
  return {{s * a.row[0], s * a.row[1], s * a.row[2]}};
}
template<class T> Vec3<T> operator*(const Mat3<T>& a, const Vec3<T>& v) {
  return {dot(a.row[0], v), dot(a.row[1], v), dot(a.row[2], v)};
}
template<class T> Mat3<T> operator*(const Mat3<T>& a, const Mat3<T>& b) {
  Mat3<T> c;
  for (int i = 0; i < 3; i++)
    c.row[i] = a.row[i].x * b.row[0] + a.row[i].y * b.row[1] + a.row[i].z * b.row[2];
  return c;
}
template<class T> Mat3<T> transpose(const Mat3<T>& a) {
  return {{{a.row[0].x, a.row[1].x, a.row[2].x},
           {a.row[0].y, a.row[1].y, a.row[2].y},
           {a.row[0].z, a.row[1].z, a.row[2].z}}};
}
template<class T> T determinant(const Mat3<T>& a) { return dot(a.row[0], cross(a.row[1], a.row[2])); }
/// Inverse by cofactors. Requires: a non-zero determinant.
template<class T> Mat3<T> inverse(const Mat3<T>& a) {
  const Vec3<T> c0 = cross(a.row[1], a.row[2]), c1 = cross(a.row[2], a.row[0]),
                c2 = cross(a.row[0], a.row[1]);
  const T d = T(1) / dot(a.row[0], c0);
  return transpose(Mat3<T>{{c0 * d, c1 * d, c2 * d}});
}
/// a b^T
template<class T> Mat3<T> outer(const Vec3<T>& a, const Vec3<T>& b) { return {{a.x * b, a.y * b, a.z * b}}; }
template<class T> Mat3<T> full(const Sym3<T>& s) {
  return {{{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}}};
}
inline Sym3d wide(const Sym3f& s) {
  const auto to = [](float a) { return static_cast<double>(a); };
  return {to(s.xx), to(s.yy), to(s.zz), to(s.xy), to(s.yz), to(s.xz)};
}
inline Sym3f single(const Sym3d& s) {
  const auto to = [](double a) { return static_cast<float>(a); };
  return {to(s.xx), to(s.yy), to(s.zz), to(s.xy), to(s.yz), to(s.xz)};
}
/// (a + a^T)/2
template<class T> Sym3<T> symmetric(const Mat3<T>& a) {
  const T h = T(0.5);
  return {a.row[0].x,
          a.row[1].y,
          a.row[2].z,
          h * (a.row[0].y + a.row[1].x),
          h * (a.row[1].z + a.row[2].y),
          h * (a.row[0].z + a.row[2].x)};
}
template<class T> Sym3<T> operator+(const Sym3<T>& a, const Sym3<T>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.xz + b.xz};
}
template<class T> Sym3<T> operator-(const Sym3<T>& a, const Sym3<T>& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.yz - b.yz, a.xz - b.xz};
}
template<class T> Sym3<T> operator*(const T& s, const Sym3<T>& a) {
  return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.xz};
}
template<class T> Vec3<T> operator*(const Sym3<T>& a, const Vec3<T>& v) {
  return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
          a.xz * v.x + a.yz * v.y + a.zz * v.z};
}
template<class T> T trace(const Sym3<T>& a) { return a.xx + a.yy + a.zz; }
/// a : b
template<class T> T doubleDot(const Sym3<T>& a, const Sym3<T>& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + T(2) * (a.xy * b.xy + a.yz * b.yz + a.xz * b.xz);
}

}  // namespace thaw
