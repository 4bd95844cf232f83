// SPDX-License-Identifier: Apache-2.0
#include "core/solid/elasticity/moment.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace thaw {

namespace {

struct Eigen3 {
  double value[3];  ///< ascending
  Vec3d vector[3];  ///< unit vectors, in the order of the values
};

Eigen3 eigenOf(const Sym3d& s) {
  Eigen::Matrix3d m;
  m << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  Eigen3 e;
  for (int k = 0; k < 3; k++) {
    e.value[k] = solver.eigenvalues()(k);
    e.vector[k] = {solver.eigenvectors()(0, k), solver.eigenvectors()(1, k), solver.eigenvectors()(2, k)};
  }
  return e;
}

// Smallest rotation of the unit vector a to the unit vector b.
Mat3d smallestRotation(const Vec3d& a, const Vec3d& b) {
  const Vec3d v = cross(a, b);
  const double c = dot(a, b);
  const Mat3d k{{{0, -v.z, v.y}, {v.z, 0, -v.x}, {-v.y, v.x, 0}}};
  if (c > -0.999999) return identity3<double>() + k + (1 / (1 + c)) * (k * k);
  // For b = -a, half a turn about any axis perpendicular to a.
  const Vec3d across = normalized(cross(a, std::abs(a.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
  return 2.0 * outer(across, across) - identity3<double>();
}

}  // namespace

MomentInverse invertMoment(const Sym3d& a, double cutoff) {
  const double mean = trace(a) / 3;
  if (!(mean > 0)) return {};
  const Vec3d r0{a.xx, a.xy, a.xz}, r1{a.xy, a.yy, a.yz}, r2{a.xz, a.yz, a.zz};
  const Vec3d c0 = cross(r1, r2), c1 = cross(r2, r0), c2 = cross(r0, r1);
  const double determinant = dot(r0, c0);
  // With eigenvalues a >= b >= c: det/mean^3 <= 27 (c/a) a^2 b/(a + b)^3 <= 4 c/a, so c/a exceeds the cutoff
  // here.
  if (determinant > 4 * cutoff * mean * mean * mean) {
    const double d = 1 / determinant;
    return {{c0.x * d, c1.y * d, c2.z * d, 0.5 * (c0.y + c1.x) * d, 0.5 * (c1.z + c2.y) * d,
             0.5 * (c0.z + c2.x) * d},
            3};
  }
  const Eigen3 e = eigenOf(a);
  MomentInverse m;
  for (int k = 0; k < 3; k++) {
    if (!(e.value[k] > cutoff * e.value[2])) continue;
    m.rank++;
    m.inverse = m.inverse + (1 / e.value[k]) * symmetric(outer(e.vector[k], e.vector[k]));
  }
  return m;
}

Mat3d completeGradient(const Mat3d& gradU, const Sym3d& momentInverse, int rank) {
  if (rank >= 3) return gradU;
  if (rank <= 0) return Mat3d{};
  const Eigen3 e = eigenOf(momentInverse);  // the missing directions come first, with the eigenvalue 0
  if (rank == 2) {
    const Vec3d n = e.vector[0];
    const Vec3d image = cross(e.vector[1] + gradU * e.vector[1], e.vector[2] + gradU * e.vector[2]);
    const double handed = dot(cross(e.vector[1], e.vector[2]), n) < 0 ? -1 : 1;
    const double size = length(image);
    return size > 0 ? gradU + outer((handed / size) * image - n, n) : gradU;
  }
  const Vec3d t = e.vector[2], image = t + gradU * t;
  const double stretch = length(image);
  if (!(stretch > 0)) return gradU;
  const Mat3d turn = smallestRotation(t, image / stretch);
  const Mat3d along = outer(t, t), across = identity3<double>() - along;
  return outer(image, t) + turn * across - identity3<double>();
}

Mat3d stressOfNormal(const FlatNeighbourhood& flat) {
  const Eigen3 e = eigenOf(flat.momentInverse);
  const Vec3d n = e.vector[0], image = n + flat.gradU * n, a = e.vector[1] + flat.gradU * e.vector[1],
              b = e.vector[2] + flat.gradU * e.vector[2], across = cross(a, b);
  // n A n
  const double size = length(across), lost = std::max(0.0, flat.trace - 1 / e.value[1] - 1 / e.value[2]);
  if (!(size > 0)) return {};
  const Vec3d y = flat.stress * n - flat.penalty * (flat.sum * n + lost * (n - image));
  const Vec3d turning = ((dot(across, image) < 0 ? -1 : 1) / size) * (y - dot(y, image) * image);
  return outer(cross(b, turning), e.vector[1]) + outer(cross(turning, a), e.vector[2]);
}

}  // namespace thaw
