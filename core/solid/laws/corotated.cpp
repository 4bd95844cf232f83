#include "core/solid/laws/corotated.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

#include "core/solid/laws/neo_hookean.hpp"

namespace thaw {

namespace {

double squareOf(const Mat3d& a) { return dot(a.row[0], a.row[0]) + dot(a.row[1], a.row[1]) + dot(a.row[2], a.row[2]); }
double doubleDot(const Mat3d& a, const Mat3d& b) { return dot(a.row[0], b.row[0]) + dot(a.row[1], b.row[1]) + dot(a.row[2], b.row[2]); }

Mat3d rotationBySvd(const Mat3d& f) {
  Eigen::Matrix3d m;
  for (int r = 0; r < 3; r++)
    for (int c = 0; c < 3; c++) m(r, c) = f.row[r][c];
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  // singular values come in descending order: the last one takes the sign
  if (u.determinant() * svd.matrixV().determinant() < 0) u.col(2) = -u.col(2);
  const Eigen::Matrix3d r = u * svd.matrixV().transpose();
  Mat3d out;
  for (int i = 0; i < 3; i++) out.row[i] = {r(i, 0), r(i, 1), r(i, 2)};
  return out;
}

}  // namespace

Mat3d nearestRotation(const Mat3d& f) {
  const double size = squareOf(f) / 3, j = determinant(f);
  // Newton's iteration R <- (R + R^-T)/2 keeps the sign of the determinant and converges quadratically (Higham 1986);
  // near singular or inverted F it does not lead to the wanted rotation.
  if (j > 0.05 * size * std::sqrt(size)) {
    Mat3d r = f;
    for (int n = 0; n < 20; n++) {
      const Mat3d next = 0.5 * (r + (1 / determinant(r)) * cofactor(r));
      const double change = squareOf(next - r);
      r = next;
      if (change < 1e-20) return 0.5 * (r + (1 / determinant(r)) * cofactor(r));
    }
  }
  return rotationBySvd(f);
}

double corotatedEnergy(const Mat3d& f, double lambda, double mu) {
  const Mat3d r = nearestRotation(f);
  const double t = doubleDot(r, f - r);
  return mu * squareOf(f - r) + 0.5 * lambda * t * t;
}

Mat3d corotatedStress(const Mat3d& f, double lambda, double mu) {
  const Mat3d r = nearestRotation(f);
  return (2 * mu) * (f - r) + (lambda * doubleDot(r, f - r)) * r;
}

}  // namespace thaw
