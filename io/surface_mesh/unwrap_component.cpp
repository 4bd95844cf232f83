// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/unwrap_component.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/surface/search/bins.hpp"
#include "io/surface_mesh/plane_field.hpp"

namespace thaw {

namespace {

using Image = std::array<int, 3>;  // whole periods along each axis

Image operator+(const Image& a, const Image& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Image operator-(const Image& a, const Image& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vec3d shiftOf(const PeriodicSides& sides, const Image& n) {
  return {n[0] * sides.period.x, n[1] * sides.period.y, n[2] * sides.period.z};
}

Vec3d vectorOf(const Vec3f& v) { return {v.x, v.y, v.z}; }

/// Disjoint sets of rows, each with its image relative to its parent's.
struct JoinedRows {
  explicit JoinedRows(std::size_t n) : parent(n), image(n, Image{}) {
    std::iota(parent.begin(), parent.end(), 0u);
  }
  /// Returns the root of i's set; image[i] is then relative to it.
  std::uint32_t find(std::uint32_t i) {
    std::uint32_t root = i;
    Image total{};
    for (; parent[root] != root; root = parent[root]) total = total + image[root];
    while (parent[i] != root && i != root) {
      const std::uint32_t next = parent[i];
      const Image own = image[i];
      parent[i] = root, image[i] = total;
      total = total - own;
      i = next;
    }
    return root;
  }
  /// Joins i with image n of j. If another image of j is joined already, the body joins its own image.
  void join(std::uint32_t i, std::uint32_t j, const Image& n, std::array<bool, 3>& selfJoined) {
    const std::uint32_t a = find(i), b = find(j);
    const Image beside = image[i] + n - image[j];  // image of b relative to a
    if (a != b) {
      parent[b] = a, image[b] = beside;
      return;
    }
    for (std::size_t axis = 0; axis < 3; axis++) selfJoined[axis] = selfJoined[axis] || beside[axis] != 0;
  }
  std::vector<std::uint32_t> parent;
  std::vector<Image> image;
};

/// Rows and their images within `reach` (m) of the domain.
struct Images {
  std::vector<Vec3d> places;
  std::vector<std::uint32_t> row;
  std::vector<Image> image;
  Bins bins;
  Images(const std::vector<Vec3d>& wrapped, const PeriodicSides& sides, double reach) {
    Image most{};
    for (std::size_t a = 0; a < 3; a++)
      if (sides.is[a]) most[a] = static_cast<int>(std::ceil(reach / sides.period[static_cast<int>(a)]));
    for (int z = -most[2]; z <= most[2]; z++)
      for (int y = -most[1]; y <= most[1]; y++)
        for (int x = -most[0]; x <= most[0]; x++) {
          const Image n{x, y, z};
          for (std::uint32_t i = 0; i < wrapped.size(); i++) {
            const Vec3d p = wrapped[i] + shiftOf(sides, n);
            bool near = true;
            for (int a = 0; a < 3; a++)
              near = near && (n[static_cast<std::size_t>(a)] == 0 ||
                              (p[a] > sides.min[a] - reach && p[a] < sides.min[a] + sides.period[a] + reach));
            if (near) places.push_back(p), row.push_back(i), image.push_back(n);
          }
        }
    fillBins(places.data(), places.size(), reach, bins);
  }
};

struct Finder {
  const SurfaceFrame& frame;
  const std::vector<std::uint32_t>& rows;
  const PeriodicSides& sides;
  std::vector<Vec3d> at;  // m, wrapped into the domain
  JoinedRows joined;
  std::array<bool, 3> selfJoined{};
  bool crosses = false;  // some pair is joined across a side

  Vec3d normal(std::uint32_t i) const { return vectorOf(frame.normals[rows[i]]); }
  double radius(std::uint32_t i) const { return frame.radii[rows[i]]; }

  void joinNear() {
    double reach = 0;
    for (std::uint32_t i = 0; i < rows.size(); i++) reach = std::max(reach, 2 * radius(i));
    const Images near(at, sides, reach);
    for (std::uint32_t i = 0; i < rows.size(); i++)
      forRowsWithin(near.bins, at[i], 2 * radius(i), [&](std::uint32_t k, double) {
        const std::uint32_t j = near.row[k];
        if (dot(normal(i), normal(j)) < planeAgreement) return;
        crosses = crosses || near.image[k] != Image{};
        joined.join(i, j, near.image[k], selfJoined);
      });
  }

  /// Returns the sets of rows, largest first.
  std::vector<std::vector<std::uint32_t>> parts() {
    std::vector<std::vector<std::uint32_t>> of(rows.size());
    for (std::uint32_t i = 0; i < rows.size(); i++) of[joined.find(i)].push_back(i);
    std::erase_if(of, [](const auto& part) { return part.empty(); });
    std::stable_sort(of.begin(), of.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return of;
  }

  struct Pair {
    double distance2;
    std::uint32_t i, j;
    Image image;
  };

  /// Joins sets at their nearest pairs across the inside, nearest first.
  void joinParts() {
    double size = 0, reach = 0;
    for (int a = 0; a < 3; a++)
      if (sides.is[static_cast<std::size_t>(a)]) size = std::max(size, sides.period[a]);
    for (std::uint32_t i = 0; i < rows.size(); i++) reach = std::max(reach, 4 * radius(i));
    for (; reach < 2 * size; reach *= 2) {
      const auto all = parts();
      if (all.size() < 2) return;
      const Images near(at, sides, std::min(reach, size));
      std::vector<Pair> pairs;
      for (std::size_t part = 1; part < all.size(); part++)  // all sets but the largest search
        for (const std::uint32_t i : all[part]) {
          Pair best{reach * reach, i, i, {}};
          forRowsWithin(near.bins, at[i], reach, [&](std::uint32_t k, double d2) {
            const std::uint32_t j = near.row[k];
            if (d2 >= best.distance2 || joined.find(j) == joined.find(i)) return;
            const Vec3d across = near.places[k] - at[i];
            if (dot(across, normal(i)) < 0 && dot(across, normal(j)) > 0) best = {d2, i, j, near.image[k]};
          });
          if (best.j != i) pairs.push_back(best);
        }
      std::stable_sort(pairs.begin(), pairs.end(),
                       [](const Pair& a, const Pair& b) { return a.distance2 < b.distance2; });
      for (const Pair& p : pairs)
        if (joined.find(p.i) != joined.find(p.j)) joined.join(p.i, p.j, p.image, selfJoined);
    }
  }

  Vec3d placed(std::uint32_t i) {
    joined.find(i);
    Image n = joined.image[i];
    for (std::size_t a = 0; a < 3; a++)
      if (selfJoined[a]) n[a] = 0;
    return at[i] + shiftOf(sides, n);
  }
};

/// Returns whether the discs enclose a hollow rather than a body.
bool isHollow(const SurfaceFrame& frame, const std::vector<std::uint32_t>& rows,
              const std::vector<Vec3d>& places) {
  Vec3d middle{}, open{};
  for (const Vec3d& x : places) middle += x / static_cast<double>(places.size());
  double area = 0, volume = 0;
  for (std::size_t i = 0; i < rows.size(); i++) {
    const double r2 = static_cast<double>(frame.radii[rows[i]]) * frame.radii[rows[i]];
    const Vec3d n = r2 * vectorOf(frame.normals[rows[i]]);
    area += r2, open += n, volume += dot(places[i] - middle, n);
  }
  return rows.size() >= 12 && volume < 0 && length(open) < 0.1 * area;
}

}  // namespace

PeriodicSides periodicSidesOf(const Domain& d) {
  PeriodicSides sides;
  sides.min = d.min;
  sides.period = d.max - d.min;
  for (std::size_t a = 0; a < 3; a++) sides.is[a] = d.side[a][0] == Side::Periodic;
  return sides;
}

UnwrappedComponent unwrapComponent(const SurfaceFrame& frame, const std::vector<std::uint32_t>& rows,
                                   const PeriodicSides& sides) {
  UnwrappedComponent whole;
  for (const std::uint32_t i : rows) whole.positions.push_back(frame.positions[i]);
  if (!sides.any() || rows.empty()) return whole;
  Finder f{frame, rows, sides, whole.positions, JoinedRows(rows.size())};
  for (Vec3d& x : f.at)
    for (int a = 0; a < 3; a++)
      if (sides.is[static_cast<std::size_t>(a)])
        x[a] -= sides.period[a] * std::floor((x[a] - sides.min[a]) / sides.period[a]);
  f.joinNear();
  if (f.crosses && f.selfJoined != sides.is) f.joinParts();
  for (std::uint32_t i = 0; i < rows.size(); i++) whole.positions[i] = f.placed(i);
  whole.selfJoined = f.selfJoined;
  if (f.selfJoined == std::array<bool, 3>{} && isHollow(frame, rows, whole.positions)) {
    whole.selfJoined = sides.is;
    whole.positions = f.at;
  }
  Vec3d mean{};
  for (const Vec3d& x : whole.positions) mean += x / static_cast<double>(rows.size());
  for (int a = 0; a < 3; a++) {
    if (!sides.is[static_cast<std::size_t>(a)] || whole.selfJoined[static_cast<std::size_t>(a)]) continue;
    const double back = sides.period[a] * std::floor((mean[a] - sides.min[a]) / sides.period[a]);
    for (Vec3d& x : whole.positions) x[a] -= back;
  }
  return whole;
}

}  // namespace thaw
