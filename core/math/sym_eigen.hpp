// SPDX-License-Identifier: Apache-2.0
// Eigenvalues and eigenvectors of a symmetric 3x3 tensor.
#pragma once
#include <cmath>

#include "core/math/mat3.hpp"

namespace thaw {

struct SymEigen {
  double value[3];
  Vec3d vector[3];  ///< unit vectors
};

/// Returns the eigenvalues in no particular order. Jacobi rotations: each eigenvalue is exact up to
/// rounding of the largest one.
inline SymEigen eigenOf(const Sym3d& s) {
  double a[3][3] = {{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}},
         v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const double size = std::sqrt(doubleDot(s, s));
  for (int sweep = 0; sweep < 12; sweep++) {
    if (!(std::abs(a[0][1]) + std::abs(a[0][2]) + std::abs(a[1][2]) > 1e-17 * size)) break;
    for (int p = 0; p < 2; p++)
      for (int q = p + 1; q < 3; q++) {
        if (a[p][q] == 0) continue;
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(t * t + 1), sine = t * c;
        const int r = 3 - p - q;
        const double off = a[p][q], rp = a[r][p], rq = a[r][q];
        a[p][p] -= t * off;
        a[q][q] += t * off;
        a[p][q] = a[q][p] = 0;
        a[r][p] = a[p][r] = c * rp - sine * rq;
        a[r][q] = a[q][r] = sine * rp + c * rq;
        for (auto& row : v) {
          const double vp = row[p], vq = row[q];
          row[p] = c * vp - sine * vq;
          row[q] = sine * vp + c * vq;
        }
      }
  }
  return {{a[0][0], a[1][1], a[2][2]},
          {{v[0][0], v[1][0], v[2][0]}, {v[0][1], v[1][1], v[2][1]}, {v[0][2], v[1][2], v[2][2]}}};
}

/// Returns the tensor with the same eigenvectors and the given eigenvalues.
inline Sym3d withValues(const SymEigen& e, const double (&value)[3]) {
  Sym3d s;
  for (int k = 0; k < 3; k++) {
    const Vec3d& n = e.vector[k];
    s = s + value[k] * Sym3d{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.x * n.z};
  }
  return s;
}

}  // namespace thaw
