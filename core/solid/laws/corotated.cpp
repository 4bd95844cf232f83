// SPDX-License-Identifier: Apache-2.0
#include "core/solid/laws/corotated.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace thaw {

namespace {

Mat3d rotationBySvd(const Mat3d& f) {
  Eigen::Matrix3d m;
  for (int r = 0; r < 3; r++)
    for (int c = 0; c < 3; c++) m(r, c) = f.row[r][c];
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  // Singular values are in descending order, so the smallest one gets the negative sign.
  if (u.determinant() * svd.matrixV().determinant() < 0) u.col(2) = -u.col(2);
  const Eigen::Matrix3d r = u * svd.matrixV().transpose();
  Mat3d out;
  for (int i = 0; i < 3; i++) out.row[i] = {r(i, 0), r(i, 1), r(i, 2)};
  return out;
}

}  // namespace

Mat3d nearestRotation(const Mat3d& f) {
  const double size = doubleDot(f, f) / 3;
  if (determinant(f) > newtonsShare * size * std::sqrt(size)) {
    Mat3d r = f;
    for (int n = 0; n < newtonsSteps; n++) {
      const Mat3d next = towardsRotation(r), change = next - r;
      r = next;
      if (!(doubleDot(change, change) > newtonsEnd)) return r;
    }
  }
  return rotationBySvd(f);
}

void nearestRotationOfLane(const double f[9][8], int lane, double rotation[9][8]) {
  Mat3d m;
  for (int r = 0; r < 3; r++)
    for (int c = 0; c < 3; c++) m.row[r][c] = f[3 * r + c][lane];
  m = nearestRotation(m);
  for (int r = 0; r < 3; r++)
    for (int c = 0; c < 3; c++) rotation[3 * r + c][lane] = m.row[r][c];
}

}  // namespace thaw
