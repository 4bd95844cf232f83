// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/interpolation/hermite_fit.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace thaw {
namespace {

using Eigen::Index;

double at(const Vec3d& v, Index a) { return v[static_cast<int>(a)]; }

}  // namespace

HermitePiece hermitePiece(const Vec3d& centre, double scale, const std::vector<Vec3d>& points,
                          const std::vector<Vec3d>& normals) {
  HermitePiece piece{centre, scale, {}, {}};
  for (const Vec3d& x : points) piece.points.push_back((x - centre) / scale);
  const auto n = static_cast<Index>(points.size());
  Eigen::MatrixXd m(4 * n, 4 * n);
  Eigen::VectorXd right(4 * n);
  for (Index i = 0; i < n; i++) {
    right[4 * i] = 0;
    for (Index a = 0; a < 3; a++) right[4 * i + 1 + a] = at(normals[static_cast<std::size_t>(i)], a);
    for (Index j = 0; j < n; j++) {
      const Vec3d d = piece.points[static_cast<std::size_t>(i)] - piece.points[static_cast<std::size_t>(j)];
      const double r = length(d);
      m(4 * i, 4 * j) = r * r * r;
      for (Index a = 0; a < 3; a++) {
        m(4 * i, 4 * j + 1 + a) = -3 * r * at(d, a);
        m(4 * i + 1 + a, 4 * j) = 3 * r * at(d, a);
        for (Index b = 0; b < 3; b++)
          m(4 * i + 1 + a, 4 * j + 1 + b) = -3 *
                                            ((a == b ? r : 0.0) + (r > 0 ? at(d, a) * at(d, b) / r : 0.0));
      }
    }
  }
  const Eigen::VectorXd weight = m.partialPivLu().solve(right);
  piece.weight.assign(weight.data(), weight.data() + 4 * n);
  if (!weight.allFinite() || !((m * weight - right).norm() < 1e-6 * right.norm())) piece.points.clear();
  return piece;
}

HermiteValue valueOf(const HermitePiece& piece, const Vec3d& place) {
  const Vec3d x = (place - piece.centre) / piece.scale;
  HermiteValue v{0, {}};
  for (std::size_t j = 0; j < piece.points.size(); j++) {
    const Vec3d d = x - piece.points[j];
    const double r = length(d), alpha = piece.weight[4 * j];
    const Vec3d beta{piece.weight[4 * j + 1], piece.weight[4 * j + 2], piece.weight[4 * j + 3]};
    v.value += alpha * r * r * r - 3 * r * dot(beta, d);
    v.gradient += (3 * alpha * r) * d - 3.0 * (r * beta + (r > 0 ? dot(beta, d) / r : 0.0) * d);
  }
  v.value *= piece.scale;
  return v;
}

}  // namespace thaw
