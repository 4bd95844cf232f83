// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/cell_fractions.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace thaw {
namespace {

constexpr int across = 4;  // samples per edge
constexpr double halfDiagonal = 0.8661;
constexpr double rounding = 1e-6;  // spacings; tolerance of equal distances, independent of the body's
                                   // position

/// A cell by its lattice position.
struct Cell {
  std::int64_t at[3];
};

class CellFractions {
 public:
  CellFractions(const SignedDistance& shape, const SampleLattice& l)
      : shape_(shape), l_(l), edge_(std::max({l.cell.x, l.cell.y, l.cell.z})) {}

  std::int32_t of(std::int64_t point) {
    const Cell c = cellOf(point);
    const double d = shape_.distanceWithin(middle(c), 3 * edge_);
    if (-d > 3 * halfDiagonal * edge_) return wholeCell;
    std::int32_t share = -d > halfDiagonal * edge_ ? wholeCell
                                                   : static_cast<std::int32_t>(samplesIn(c).size());
    forAround(c, [&](const Cell& o) {
      if (isInside(o)) return;
      for (const Piece& p : piecesOf(o))
        if (p.point == point) share += p.samples;
    });
    return share;
  }

 private:
  struct Piece {
    std::int64_t point;
    std::int32_t samples;
  };
  const SignedDistance& shape_;
  const SampleLattice& l_;
  double edge_;                                                  // m, longest edge of a cell
  std::unordered_map<std::int64_t, std::vector<Piece>> pieces_;  // by cell without a particle: the
                                                                 // particles that own its parts

  std::int64_t numberOf(const Cell& c) const {
    return c.at[0] + l_.count[0] * (c.at[1] + l_.count[1] * c.at[2]);
  }
  Cell cellOf(std::int64_t n) const {
    return {{n % l_.count[0], n / l_.count[0] % l_.count[1], n / l_.count[0] / l_.count[1]}};
  }
  Vec3d middle(const Cell& c) const { return l_.at(c.at[0], c.at[1], c.at[2]); }
  bool isInside(const Cell& c) const { return shape_.distanceWithin(middle(c), edge_) < 0; }

  /// Visits the surrounding cells (up to 26) that are in the lattice. The lattice covers the body.
  template<class F> void forAround(const Cell& c, const F& f) const {
    for (std::int64_t z = -1; z <= 1; z++)
      for (std::int64_t y = -1; y <= 1; y++)
        for (std::int64_t x = -1; x <= 1; x++) {
          const Cell o{{c.at[0] + x, c.at[1] + y, c.at[2] + z}};
          bool in = x != 0 || y != 0 || z != 0;
          for (int a = 0; a < 3; a++) in = in && o.at[a] >= 0 && o.at[a] < l_.count[a];
          if (in) f(o);
        }
  }

  std::vector<Vec3d> samplesIn(const Cell& c) const {
    std::vector<Vec3d> in;
    const Vec3d edges = l_.edges(c.at[0], c.at[1], c.at[2]);
    const auto off = [&](int k, int a) { return ((k + 0.5) / across - 0.5) * edges[a]; };
    for (int z = 0; z < across; z++)
      for (int y = 0; y < across; y++)
        for (int x = 0; x < across; x++)
          if (const Vec3d at = middle(c) + l_.along({off(x, 0), off(y, 1), off(z, 2)});
              shape_.distanceWithin(at, edge_) < -rounding * edge_)
            in.push_back(at);
    return in;
  }

  const std::vector<Piece>& piecesOf(const Cell& c) {
    const auto [found, fresh] = pieces_.try_emplace(numberOf(c));
    std::vector<Piece>& pieces = found->second;
    if (!fresh || !(shape_.distanceWithin(middle(c), edge_) < halfDiagonal * edge_)) return pieces;
    std::vector<Vec3d> places;
    forAround(c, [&](const Cell& o) {
      if (isInside(o)) pieces.push_back({numberOf(o), 0}), places.push_back(middle(o));
    });
    for (const Vec3d& x : samplesIn(c)) {
      std::size_t nearest = 0;
      const auto away = [&](std::size_t k) { return length(places[k] - x); };
      for (std::size_t k = 1; k < places.size(); k++)
        if (away(k) < away(nearest) - rounding * edge_) nearest = k;
      if (!places.empty()) pieces[nearest].samples++;
    }
    return pieces;
  }
};

}  // namespace

std::vector<std::int32_t> cellFractions(const SignedDistance& shape, const SampleLattice& l,
                                        const std::vector<std::int64_t>& points) {
  std::vector<std::int32_t> shares(points.size(), wholeCell);
  if (shape.hasGaps()) return shares;
  CellFractions cells(shape, l);
  for (std::size_t i = 0; i < points.size(); i++) shares[i] = cells.of(points[i]);
  return shares;
}

}  // namespace thaw
