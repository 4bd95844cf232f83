#include "core/surface/surfel_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace thaw {
namespace {

constexpr double cosFlat = 0.5;  // 60 degrees: on the sphere of a single particle normals turn by up to 55 from surfel to surfel
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

using Candidate = AreaLists::Candidate;

/// Cuts the cell by neighbours in their order until none farther away can reach it; 4 times the square of how far it extends at the end.
double cutCell(const Surfels& f, std::size_t i, std::span<const Candidate> near, Cell& cell) {
  const Vec3d n = f.normal[i], e1 = normalized(f.tangent[i] - dot(f.tangent[i], n) * n), e2 = cross(n, e1);
  double reach2 = 4 * cell.farthest2();
  for (const Candidate& c : near) {
    if (c.d2 > reach2 || cell.full()) break;
    const Vec3d d = f.position[c.row] - f.position[i], other = f.normal[c.row];
    const double cosine = dot(n, other), height = dot(d, n);
    if (cosine < cosBack) continue;
    const double flat2 = c.d2 - height * height;
    if (flat2 < 1e-12 * f.radius[i] * f.radius[i]) continue;
    const Point2 flat{dot(d, e1), dot(d, e2)};
    double stretch = 1;  // arc over flat length
    if (cosine < cosFlat) {  // over an edge: where its plane meets ours
      const double over = dot(d, other);
      const double sign = over < 0 ? -1 : 1;
      const Point2 a{sign * dot(other, e1), sign * dot(other, e2)};
      if (over * over <= (1 + 1e-9) * flat2 * (a.x * a.x + a.y * a.y)) {  // the same right over the edge
        if (cell.cut(a, sign * over)) reach2 = 4 * cell.farthest2();
        continue;
      }
    } else if (height * height > 0.5 * c.d2) {
      continue;  // above or below: another layer
    } else {
      stretch = std::sqrt(c.d2 / flat2) * (1 + (1 - cosine) / 12);
    }
    if (cell.cut({stretch * flat.x, stretch * flat.y}, 0.5 * stretch * stretch * flat2)) reach2 = 4 * cell.farthest2();
  }
  return reach2;
}

}  // namespace

namespace {

constexpr double reach = 2.31;  // of what may cut a hexagon: twice its corners
constexpr double usual = 1.75;  // most cells end within half of this

/// Who may cut whose cell, as long as none comes `slack` (m) nearer.
void listNear(const Surfels& f, double slack, AreaLists& l) {
  double largest = 0;
  for (std::size_t i = 0; i < f.owned; i++) largest = std::max(largest, f.radius[i]);
  fillBins(f.position.data(), f.size(), usual * largest, l.bins);
  l.found.assign(f.position.data(), f.position.data() + f.size());
  l.first.assign(f.owned, 0);
  l.end.assign(f.owned, 0);
  l.near.clear();
  forBlocks(l.bins, l.bins, usual * largest + slack, l.block, [&](std::uint32_t i, const RowBlock& block) {
    if (i >= f.owned) return;
    const double r = usual * f.radius[i] + slack, r2 = r * r;
    const Vec3d x = f.position[i];
    l.first[i] = l.near.size();
    for (std::size_t k = 0; k < block.count; k++) {
      const Vec3d d = block.at[k] - x;
      const double d2 = dot(d, d);
      const std::uint32_t j = block.row[k];
      if (d2 <= r2 && j != i && f.component[j] == f.component[i]) l.near.push_back({d2, f.id[j], j});
    }
    l.end[i] = l.near.size();
    std::sort(l.near.begin() + static_cast<std::ptrdiff_t>(l.first[i]), l.near.end());
  });
}

/// Is it the same surface as in the lists, but for moves of less than half the slack?
bool stillHolds(const Surfels& f, double slack, const AreaLists& l) {
  if (l.found.size() != f.size() || l.first.size() != f.owned) return false;
  for (std::size_t i = 0; i < f.size(); i++) {
    const Vec3d d = f.position[i] - l.found[i];
    if (!(4 * dot(d, d) < slack * slack)) return false;
  }
  return true;
}

}  // namespace

void findSurfelAreas(Surfels& f, AreaLists& l, bool again) {
  double slack = 0;
  for (std::size_t i = 0; i < f.size(); i++) slack = std::max(slack, 0.25 * f.radius[i]);
  if (!again || !stillHolds(f, slack, l)) listNear(f, slack, l);
  std::vector<Candidate> wide;
  for (std::size_t i = 0; i < f.owned; i++) {
    const std::span<Candidate> near(l.near.data() + l.first[i], l.end[i] - l.first[i]);
    if (again) {
      for (std::size_t k = 0; k < near.size(); k++) {  // almost in order
        Candidate c = near[k];
        const Vec3d d = f.position[c.row] - f.position[i];
        c.d2 = dot(d, d);
        std::size_t to = k;
        for (; to > 0 && c < near[to - 1]; to--) near[to] = near[to - 1];
        near[to] = c;
      }
    }
    Cell cell(f.radius[i]);
    const double left2 = cutCell(f, i, near, cell), known = usual * f.radius[i];
    if (left2 > known * known) {  // beside a hole or a rim
      wide.clear();
      forRowsWithin(l.bins, f.position[i], reach * f.radius[i] + slack, [&](std::uint32_t j, double) {
        const Vec3d d = f.position[j] - f.position[i];
        if (j != i && f.component[j] == f.component[i]) wide.push_back({dot(d, d), f.id[j], j});
      });
      std::sort(wide.begin(), wide.end());
      cell = Cell(f.radius[i]);
      cutCell(f, i, wide, cell);
    }
    f.area[i] = cell.area();
  }
}

}  // namespace thaw
