// SPDX-License-Identifier: Apache-2.0
#include "core/surface/measures/surfel_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "core/surface/measures/facets.hpp"

namespace thaw {
namespace {

// Cosine of 60 degrees. On the sphere of a single particle, normals of adjacent surfels differ by up to 55
// degrees.
constexpr double cosFlat = 0.5;
constexpr double cosBack = -0.5;
constexpr std::uint32_t noRow = ~0u;

struct Point2 {
  double x, y;
};

/// Convex cell around the origin.
class Cell {
 public:
  /// Makes a hexagon around a circle of this radius (m).
  explicit Cell(double radius) {
    static const auto corner = [] {
      std::array<Point2, 6> c;
      for (std::size_t k = 0; k < c.size(); k++) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k) / 6,
                     r = 1 / std::cos(std::numbers::pi / 6);
        c[k] = {r * std::cos(angle), r * std::sin(angle)};
      }
      return c;
    }();
    for (std::size_t k = 0; k < corner.size(); k++)
      corner_[k] = {radius * corner[k].x, radius * corner[k].y}, beyond_[k] = noRow;
    n_ = corner.size();
  }
  double farthest2() const {
    double r2 = 0;
    for (std::size_t k = 0; k < n_; k++)
      r2 = std::max(r2, corner_[k].x * corner_[k].x + corner_[k].y * corner_[k].y);
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
  /// Appends the neighbours at the cell's borders in order. Returns the length of the remaining border of the
  /// hexagon.
  double borders(std::vector<std::uint32_t>& ring) const {
    double rim = 0;
    for (std::size_t k = 0; k < n_; k++) {
      const Point2 &a = corner_[k], &b = corner_[k + 1 < n_ ? k + 1 : 0];
      if (beyond_[k] != noRow) ring.push_back(beyond_[k]);
      else rim += std::hypot(b.x - a.x, b.y - a.y);
    }
    return rim;
  }
  /// Clips the cell to a . p <= b with b >= 0. row: neighbour beyond the new border. Returns whether the cell
  /// changed.
  bool clipAt(const Point2& a, double b, std::uint32_t row) {
    bool any = false;
    for (std::size_t k = 0; k < n_; k++) {
      over_[k] = a.x * corner_[k].x + a.y * corner_[k].y - b;
      any |= over_[k] > 0;
    }
    if (!any) return false;
    std::size_t m = 0;
    std::array<Point2, most> kept;
    std::array<std::uint32_t, most> beyond;
    for (std::size_t k = 0; k < n_; k++) {
      const std::size_t next = k + 1 < n_ ? k + 1 : 0;
      const bool here = over_[k] <= 0;
      if (here) beyond[m] = beyond_[k], kept[m++] = corner_[k];
      if (here != (over_[next] <= 0)) {
        const double share = over_[k] / (over_[k] - over_[next]);
        beyond[m] = here ? row : beyond_[k];
        kept[m++] = {corner_[k].x + share * (corner_[next].x - corner_[k].x),
                     corner_[k].y + share * (corner_[next].y - corner_[k].y)};
      }
    }
    n_ = m;
    std::copy_n(kept.begin(), m, corner_.begin());
    std::copy_n(beyond.begin(), m, beyond_.begin());
    return true;
  }
  /// Returns whether another clip may exceed the maximum number of corners.
  bool full() const { return n_ + 1 >= most; }

 private:
  static constexpr std::size_t most = 40;
  std::array<Point2, most> corner_;
  std::array<std::uint32_t, most> beyond_;  // row beyond the side from corner k to the next
  std::array<double, most> over_;
  std::size_t n_ = 0;
};

struct Candidate {
  double d2;  // m^2
  std::uint64_t id;
  std::uint32_t row;
  bool operator<(const Candidate& o) const { return d2 != o.d2 ? d2 < o.d2 : id < o.id; }
};

/// Clips the cell halfway to neighbours, nearest first, until the next neighbour cannot intersect it. With
/// atEdges, neighbours across an edge clip at the intersection of the two planes instead. Returns whether
/// neighbours lie across an edge.
bool clipCell(const Surfels& f, std::size_t i, std::span<const Candidate> near, bool atEdges, Cell& cell) {
  bool edges = false;
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
    // ratio of arc length to length in the plane
    double stretch = 1;
    edges = edges || cosine < cosFlat;
    if (cosine < cosFlat && atEdges) {
      const double over = dot(d, other);
      const double sign = over < 0 ? -1 : 1;
      const Point2 a{sign * dot(other, e1), sign * dot(other, e2)};
      // Positions directly above the edge give the same result.
      if (over * over <= (1 + 1e-9) * flat2 * (a.x * a.x + a.y * a.y)) {
        if (cell.clipAt(a, sign * over, c.row)) reach2 = 4 * cell.farthest2();
        continue;
      }
    } else if (cosine >= cosFlat && height * height > 0.5 * c.d2) {
      // A higher or lower neighbour belongs to another layer.
      continue;
    } else {
      stretch = std::sqrt(c.d2 / flat2) * (1 + (1 - cosine) / 12);
    }
    if (cell.clipAt({stretch * flat.x, stretch * flat.y}, 0.5 * stretch * stretch * flat2, c.row))
      reach2 = 4 * cell.farthest2();
  }
  return edges;
}

// Range of neighbours that may clip a hexagon, in radii: twice its corners.
constexpr double reach = 2.31;
// Most cells end within half of this, in radii.
constexpr double usual = 1.8;

/// Lists the neighbours that may clip typical cells. The lists are valid until a neighbour approaches by
/// `slack` (m).
void listNear(const Surface& s, double slack, AreaLists& l) {
  const Surfels& f = s.surfels;
  double largest = 0;
  for (std::size_t i = 0; i < f.owned; i++) largest = std::max(largest, f.radius[i]);
  // The order is the same on any number of ranks.
  fillBins(s.grid, s.surfelCells, f.position.data(), 2.5 * s.spacing, l.bins);
  l.found.assign(f.position.data(), f.position.data() + f.size());
  l.queries.clear();
  l.first.assign(1, 0);
  std::size_t n = 0;
  forBlocks(l.bins, l.bins, usual * largest + slack, l.block, [&](std::uint32_t i, RowBlock& block) {
    if (i >= f.owned) return;
    const double r = usual * f.radius[i] + slack, r2 = r * r;
    const Vec3d x = f.position[i];
    const std::uint64_t component = f.component[i];
    const std::span<const std::uint32_t> around = block.around(x, r);
    if (l.near.size() < n + around.size()) l.near.resize(2 * (n + around.size()));
    for (const std::uint32_t k : around) {
      const Vec3d d = block.at[k] - x;
      const std::uint32_t j = block.row[k];
      l.near[n] = j;
      n += (dot(d, d) <= r2) & (j != i) & (f.component[j] == component);
    }
    l.queries.push_back(i);
    l.first.push_back(n);
  });
  l.near.resize(n);
}

/// Returns whether the lists are still valid, because no surfel has moved by half the slack (m).
bool stillHolds(const Surfels& f, double slack, const AreaLists& l) {
  if (l.found.size() != f.size() || l.queries.size() != f.owned) return false;
  for (std::size_t i = 0; i < f.size(); i++) {
    const Vec3d d = f.position[i] - l.found[i];
    if (!(4 * dot(d, d) < slack * slack)) return false;
  }
  return true;
}

void pack(const Surfels& f, AreaLists& l) {
  l.place.resize(4 * f.size());
  l.normal.resize(4 * f.size());
  for (std::size_t i = 0; i < f.size(); i++) {
    const Vec3d x = f.position[i], n = f.normal[i];
    double *place = &l.place[4 * i], *normal = &l.normal[4 * i];
    place[0] = x.x, place[1] = x.y, place[2] = x.z, place[3] = f.radius[i];
    normal[0] = n.x, normal[1] = n.y, normal[2] = n.z, normal[3] = 0;
  }
}

/// Clips the cell of a surfel that has a neighbour across an edge, or is next to a hole or rim.
void clipAlone(Surfels& f, std::size_t i, double slack, const Bins& bins, std::vector<Candidate>& near,
               std::vector<std::uint32_t>& ring) {
  near.clear();
  ring.clear();
  forRowsWithin(bins, f.position[i], reach * f.radius[i] + slack, [&](std::uint32_t j, double) {
    const Vec3d d = f.position[j] - f.position[i];
    if (j != i && f.component[j] == f.component[i]) near.push_back({dot(d, d), f.id[j], j});
  });
  std::sort(near.begin(), near.end());
  Cell cell(f.radius[i]);
  const bool edges = clipCell(f, i, near, true, cell);
  f.area[i] = cell.area();
  // The plane beyond an edge is the same for all surfels there. Clipping halfway determines the adjacent
  // ones.
  if (edges) {
    cell = Cell(f.radius[i]);
    clipCell(f, i, near, false, cell);
  }
  f.rim[i] = cell.borders(ring);
  measureFan(f, i, ring);
}

/// Lists the neighbours of one lane at the cell's borders, ordered around the normal. Sorts by rank without
/// branches.
void ringOf(const std::uint32_t* near, const double* turn, std::size_t count,
            std::vector<std::uint32_t>& ring) {
  std::array<double, mostAreaNeighbours + 1> key;
  std::array<std::uint32_t, mostAreaNeighbours + 1> row;
  std::array<std::uint32_t, mostAreaNeighbours> rank;
  std::size_t n = 0;
  for (std::size_t k = 0; k < count; k++) {
    key[n] = turn[8 * k];
    row[n] = near[8 * k];
    n += turn[8 * k] >= 0;
  }
  ring.resize(n);
  for (std::size_t k = 0; k < n; k++) {
    rank[k] = 0;
    for (std::size_t j = 0; j < k; j++) {
      const bool before = key[j] <= key[k];
      rank[k] += before;
      rank[j] += !before;
    }
  }
  for (std::size_t k = 0; k < n; k++) ring[rank[k]] = row[k];
}

}  // namespace

void clearAreas(Surfels& f) {
  std::fill_n(f.area.data(), f.owned, 0.0);
  std::fill_n(f.facets.data(), f.owned, Vec3d{});
  std::fill_n(f.bulge.data(), f.owned, 0.0);
  std::fill_n(f.rim.data(), f.owned, 0.0);
}

void findSurfelAreas(Surface& s, Reducer& all, AreaLists& l, bool again) {
  Surfels& f = s.surfels;
  const double slack = 0.25 * s.spacing;
  double anew = !again || !stillHolds(f, slack, l);
  // All ranks make new lists if any rank does, because new lists have another order.
  if (again) all.maximum({&anew, 1});
  if (anew > 0) listNear(s, slack, l);
  pack(f, l);
  std::vector<Candidate> wide;
  std::array<std::uint32_t, 8> self;
  std::array<std::uint32_t, 8 * mostAreaNeighbours> near;
  std::vector<std::uint32_t> ring;
  alignas(32) std::array<double, 8> area, farthest2;
  alignas(32) std::array<double, 8 * mostAreaNeighbours> turn;
  AreaCells in{l.place.data(), l.normal.data(), self.data(), near.data(), 0, cosFlat, cosBack, turn.data()};
  for (std::size_t from = 0; from < l.queries.size(); from += 8) {
    const std::size_t lanes = std::min<std::size_t>(8, l.queries.size() - from);
    std::array<bool, 8> many{};
    in.count = 0;
    for (std::size_t lane = 0; lane < 8; lane++) {
      const std::size_t k = from + std::min(lane, lanes - 1);
      const std::uint32_t i = self[lane] = l.queries[k];
      const double most = usual * f.radius[i], most2 = most * most;
      std::size_t n = 0;
      for (std::uint64_t at = l.first[k]; at < l.first[k + 1] && !many[lane]; at++) {
        const Vec3d d = f.position[l.near[at]] - f.position[i];
        near[8 * n + lane] = l.near[at];
        n += dot(d, d) <= most2;
        many[lane] = n == mostAreaNeighbours;
      }
      for (std::size_t m = in.count; m < n; m++)
        for (std::size_t other = 0; other < lane; other++) near[8 * m + other] = self[other];
      in.count = std::max(in.count, n);
      for (std::size_t m = n; m < in.count; m++) near[8 * m + lane] = i;
    }
    l.kernels->areas(in, area.data(), farthest2.data());
    for (std::size_t lane = 0; lane < lanes; lane++) {
      const std::uint32_t i = self[lane];
      const double known = usual * f.radius[i];
      if (many[lane] || !(4 * farthest2[lane] <= known * known)) {
        clipAlone(f, i, slack, l.bins, wide, ring);
        continue;
      }
      f.area[i] = area[lane];
      f.rim[i] = 0;
      ringOf(&near[lane], &turn[lane], in.count, ring);
      measureFan(f, i, ring);
    }
  }
}

}  // namespace thaw
