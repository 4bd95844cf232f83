// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/interpolation/interpolant.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <queue>
#include <stdexcept>

namespace thaw {
namespace {

constexpr std::size_t around = 12;
// Number of points of a piece of the interpolant, and number of pieces blended at a position.
constexpr std::size_t ofPiece = 24, blended = 6;

struct Plane {
  Vec3d centre, axis[3];
  double spread[3];
};  // axes in order of decreasing spread

Plane planeOf(const std::vector<Vec3d>& points, const std::vector<std::uint32_t>& which) {
  Plane p{};
  for (const std::uint32_t k : which) p.centre += points[k];
  p.centre = p.centre / static_cast<double>(which.size());
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
  for (const std::uint32_t k : which) {
    const Vec3d d = points[k] - p.centre;
    const Eigen::Vector3d e(d.x, d.y, d.z);
    c += e * e.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(c);
  for (int k = 0; k < 3; k++) {
    const Eigen::Vector3d e = solver.eigenvectors().col(2 - k);
    p.axis[k] = {e[0], e[1], e[2]};
    p.spread[k] = solver.eigenvalues()[2 - k];
  }
  return p;
}

double kernel(double r2) { return r2 > 0 ? 0.5 * r2 * std::log(r2) : 0; }  // r^2 log r

}  // namespace

void buildInterpolant(PointInterpolant& g) {
  g.tree = std::make_shared<const PointTree>(g.points);
  g.apart = 0;
  if (g.points.size() < 2) return;
  for (const Vec3d& x : g.points) g.apart += length(g.points[g.tree->nearest(x, 2)[1]] - x);
  g.apart /= static_cast<double>(g.points.size());
  for (std::size_t i = 0; i < g.points.size(); i++) {
    std::vector<Vec3d> points, normals;
    for (const std::uint32_t k : g.tree->nearest(g.points[i], ofPiece)) {
      if (!points.empty() && length(g.points[k] - g.points[i]) < 1e-6 * g.apart) continue;  // duplicate point
      points.push_back(g.points[k]);
      normals.push_back(g.normals[k]);
    }
    g.pieces.push_back(hermitePiece(g.points[i], g.apart, points, normals));
  }
}

std::vector<Vec3d> normalsOf(const std::vector<Vec3d>& points) {
  const std::size_t n = points.size();
  if (n < 3) return std::vector<Vec3d>(n, Vec3d{0, 0, 1});
  const PointTree tree(points);
  std::vector<std::vector<std::uint32_t>> near(n);
  std::vector<Vec3d> normals(n);
  for (std::size_t i = 0; i < n; i++) {
    near[i] = tree.nearest(points[i], around + 1);
    normals[i] = planeOf(points, near[i]).axis[2];
  }
  // Prim's algorithm over the symmetric neighbour graph; each component starts at its highest point
  std::vector<std::vector<std::uint32_t>> both(n);
  for (std::size_t i = 0; i < n; i++)
    for (const std::uint32_t k : near[i])
      if (k != i) both[i].push_back(k), both[k].push_back(static_cast<std::uint32_t>(i));
  std::vector<std::uint32_t> order(n);
  for (std::size_t i = 0; i < n; i++) order[i] = static_cast<std::uint32_t>(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return points[a].z > points[b].z; });
  std::vector<bool> done(n, false);
  struct Edge {
    double cost;
    std::uint32_t from, to;
  };
  const auto later = [](const Edge& a, const Edge& b) {
    return a.cost != b.cost ? a.cost > b.cost : a.to != b.to ? a.to > b.to : a.from > b.from;
  };
  for (const std::uint32_t start : order) {
    if (done[start]) continue;
    if (normals[start].z < 0) normals[start] = -normals[start];
    done[start] = true;
    std::priority_queue<Edge, std::vector<Edge>, decltype(later)> edges(later);
    const auto open = [&](std::uint32_t i) {
      for (const std::uint32_t k : both[i])
        if (!done[k]) edges.push({1 - std::abs(dot(normals[i], normals[k])), i, k});
    };
    open(start);
    while (!edges.empty()) {
      const Edge e = edges.top();
      edges.pop();
      if (done[e.to]) continue;
      if (dot(normals[e.from], normals[e.to]) < 0) normals[e.to] = -normals[e.to];
      done[e.to] = true;
      open(e.to);
    }
  }
  return normals;
}

bool projectOnInterpolant(const PointInterpolant& g, Vec3d& place, Vec3d& normal) {
  for (int pass = 0; pass < 4; pass++) {
    const std::vector<std::uint32_t> near = g.tree->nearest(place, blended + 1);
    if (near.empty() || length(g.points[near[0]] - place) > g.reach * g.apart) return false;
    // the weights of pieces fall to zero at the distance of the first excluded point
    const double radius = length(g.points[near.back()] - place) * (near.size() > blended ? 1 : 2);
    double all = 0, value = 0;
    Vec3d gradient{};
    for (const std::uint32_t k : near) {
      const double u = length(g.points[k] - place) / radius;
      if (!(u < 1) || g.pieces[k].points.empty()) continue;
      const double fade = (1 - u) * (1 - u), w = fade * fade * (4 * u + 1);
      const HermiteValue v = valueOf(g.pieces[k], place);
      all += w;
      value += w * v.value;
      gradient += w * v.gradient;
    }
    const double steep2 = dot(gradient, gradient);
    if (!(all > 0) || !(steep2 > 0.04 * all * all)) return false;
    normal = gradient / std::sqrt(steep2);
    place = place - std::clamp(value / steep2 * all, -g.apart, g.apart) / all * gradient;
  }
  for (const std::uint32_t k : g.tree->nearest(place, blended + 1))
    // a normal that opposes those of all near points is an artefact
    if (dot(g.normals[k], normal) > 0) return length(g.points[k] - place) < g.reach * g.apart;
  return false;
}

double ThinPlate::height(double px, double py) const {
  double h = constant + perX * px + perY * py;
  for (std::size_t k = 0; k < x.size(); k++)
    h += weight[k] * kernel((px - x[k]) * (px - x[k]) + (py - y[k]) * (py - y[k]));
  return h;
}

Vec3d ThinPlate::normal(double px, double py) const {
  double dx = perX, dy = perY;
  for (std::size_t k = 0; k < x.size(); k++) {
    const double a = px - x[k], b = py - y[k], r2 = a * a + b * b;
    if (!(r2 > 0)) continue;
    const double slope = weight[k] * (std::log(r2) + 1);
    dx += slope * a;
    dy += slope * b;
  }
  return normalized(n - dx * u - dy * v);
}

ThinPlate thinPlate(const std::vector<Vec3d>& points) {
  std::vector<std::uint32_t> all(points.size());
  for (std::size_t k = 0; k < all.size(); k++) all[k] = static_cast<std::uint32_t>(k);
  if (points.size() < 3)
    throw std::invalid_argument(
        "a surface through control points has too few of them; expected at least three");
  const Plane plane = planeOf(points, all);
  if (!(plane.spread[1] > 1e-9 * plane.spread[0]))
    throw std::invalid_argument("the control points of a surface lie on a line; expected three that do not");
  ThinPlate t;
  t.origin = plane.centre;
  t.u = plane.axis[0];
  t.n = plane.axis[2].z < 0 ? -plane.axis[2] : plane.axis[2];
  t.v = cross(t.n, t.u);
  const auto m = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(m + 3, m + 3);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(m + 3);
  for (Eigen::Index i = 0; i < m; i++) {
    const Vec3d d = points[static_cast<std::size_t>(i)] - t.origin;
    t.x.push_back(dot(d, t.u));
    t.y.push_back(dot(d, t.v));
    b[i] = dot(d, t.n);
  }
  for (Eigen::Index i = 0; i < m; i++) {
    const auto k = static_cast<std::size_t>(i);
    for (Eigen::Index j = 0; j < m; j++) {
      const auto q = static_cast<std::size_t>(j);
      a(i, j) = kernel((t.x[k] - t.x[q]) * (t.x[k] - t.x[q]) + (t.y[k] - t.y[q]) * (t.y[k] - t.y[q]));
    }
    a(i, m) = a(m, i) = 1;
    a(i, m + 1) = a(m + 1, i) = t.x[k];
    a(i, m + 2) = a(m + 2, i) = t.y[k];
  }
  const Eigen::VectorXd c = a.fullPivLu().solve(b);
  for (Eigen::Index i = 0; i < m; i++) t.weight.push_back(c[i]);
  t.constant = c[m];
  t.perX = c[m + 1];
  t.perY = c[m + 2];
  return t;
}

}  // namespace thaw
