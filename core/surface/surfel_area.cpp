#include "core/surface/surfel_area.hpp"

#include <array>

namespace thaw {
namespace {

constexpr double cosFlat = 0.70710678118654752;  // pi/4
constexpr double cosBack = -0.5;

struct Point2 { double x, y; };

/// A convex cell around the origin.
class Cell {
 public:
  /// A hexagon around a circle.
  explicit Cell(double radius) {
    static const auto corner = [] {
      std::array<Point2, 6> c;
      for (std::size_t k = 0; k < c.size(); k++) {
        const double angle = 2 * 3.14159265358979324 * static_cast<double>(k) / 6, r = 1 / std::cos(3.14159265358979324 / 6);
        c[k] = {r * std::cos(angle), r * std::sin(angle)};
      }
      return c;
    }();
    for (std::size_t k = 0; k < corner.size(); k++) corner_[k] = {radius * corner[k].x, radius * corner[k].y};
    n_ = corner.size();
  }
  double farthest2() const {
    double r2 = 0;
    for (std::size_t k = 0; k < n_; k++) r2 = std::max(r2, corner_[k].x * corner_[k].x + corner_[k].y * corner_[k].y);
    return r2;
  }
  double area() const {
    double twice = 0;
    for (std::size_t k = 0; k < n_; k++) {
      const Point2 &a = corner_[k], &b = corner_[k + 1 < n_ ? k + 1 : 0];
      twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
  }
  /// Keeps where a.p <= b; b >= 0. Returns whether anything went.
  bool cut(const Point2& a, double b) {
    bool any = false;
    for (std::size_t k = 0; k < n_; k++) {
      over_[k] = a.x * corner_[k].x + a.y * corner_[k].y - b;
      any |= over_[k] > 0;
    }
    if (!any) return false;
    std::size_t m = 0;
    std::array<Point2, most> kept;
    for (std::size_t k = 0; k < n_; k++) {
      const std::size_t next = k + 1 < n_ ? k + 1 : 0;
      if (over_[k] <= 0) kept[m++] = corner_[k];
      if ((over_[k] <= 0) != (over_[next] <= 0)) {
        const double share = over_[k] / (over_[k] - over_[next]);
        kept[m++] = {corner_[k].x + share * (corner_[next].x - corner_[k].x), corner_[k].y + share * (corner_[next].y - corner_[k].y)};
      }
    }
    n_ = m;
    std::copy_n(kept.begin(), m, corner_.begin());
    return true;
  }
  /// Another cut may add a corner.
  bool full() const { return n_ + 1 >= most; }

 private:
  static constexpr std::size_t most = 40;
  std::array<Point2, most> corner_;
  std::array<double, most> over_;
  std::size_t n_ = 0;
};

struct Candidate {
  double d2;
  std::uint64_t id;
  std::uint32_t row;
};

double areaOf(const Surfels& f, std::size_t i, const std::vector<Candidate>& near) {
  const Vec3d n = f.normal[i], e1 = normalized(f.tangent[i] - dot(f.tangent[i], n) * n), e2 = cross(n, e1);
  Cell cell(f.radius[i]);
  double reach2 = 4 * cell.farthest2();
  for (const Candidate& c : near) {
    if (c.d2 > reach2 || cell.full()) break;
    const Vec3d d = f.position[c.row] - f.position[i], other = f.normal[c.row];
    const double cosine = dot(n, other), height = dot(d, n);
    if (cosine < cosBack) continue;
    const Vec3d flat = d - height * n;
    const double flatLength = length(flat);
    if (flatLength < 1e-9 * f.radius[i]) continue;
    if (cosine < cosFlat) {  // over an edge: where its plane meets ours
      const double over = dot(d, other);
      const double sign = over < 0 ? -1 : 1;
      const Point2 a{sign * dot(other, e1), sign * dot(other, e2)};
      if (sign * over <= flatLength * std::sqrt(a.x * a.x + a.y * a.y)) {
        if (cell.cut(a, sign * over)) reach2 = 4 * cell.farthest2();
        continue;
      }
    } else if (height * height > 0.5 * c.d2) {
      continue;  // above or below: another layer
    }
    const double arc = cosine < cosFlat ? flatLength : std::sqrt(c.d2) * (1 + (1 - cosine) / 12);
    const double s = arc / flatLength;
    if (cell.cut({s * dot(flat, e1), s * dot(flat, e2)}, 0.5 * arc * arc)) reach2 = 4 * cell.farthest2();
  }
  return cell.area();
}

}  // namespace

void findSurfelAreas(Surfels& f, PointBins& bins) {
  constexpr double reach = 2.31;  // twice the corners of a hexagon
  double largest = 0;
  for (std::size_t i = 0; i < f.owned; i++) largest = std::max(largest, f.radius[i]);
  if (f.owned == 0) return;
  bins.build(f.position.data(), f.size(), reach * largest);
  std::vector<Candidate> near;
  PointBins::Block all;
  bins.forEachBlock(bins, reach * largest, all, [&](std::uint32_t i, const PointBins::Block& block) {
    if (i >= f.owned) return;
    near.clear();
    const double r2 = reach * f.radius[i] * reach * f.radius[i];
    const Vec3d x = f.position[i];
    for (std::size_t k = 0; k < block.row.size(); k++) {
      const Vec3d d = block.at[k] - x;
      const double d2 = dot(d, d);
      const std::uint32_t j = block.row[k];
      if (d2 <= r2 && j != i && f.component[j] == f.component[i]) near.push_back({d2, f.id[j], j});
    }
    std::sort(near.begin(), near.end(), [](const Candidate& a, const Candidate& b) { return a.d2 != b.d2 ? a.d2 < b.d2 : a.id < b.id; });
    f.area[i] = areaOf(f, i, near);
  });
}

}  // namespace thaw
