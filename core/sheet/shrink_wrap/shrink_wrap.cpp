// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/shrink_wrap/shrink_wrap.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/trees/point_tree.hpp"
#include "core/sheet/forces/cell_sums.hpp"
#include "core/sheet/shrink_wrap/shrink_wrap_surface.hpp"

namespace thaw {
namespace {

constexpr double blunt = 0.2;  // smallest denominator of a direction, over sum w r

/// Rows of a body of any type on this rank.
struct ShrinkWrapBody {
  const SheetView& w;
  ShrinkWrapTarget target;
  const CellTable& cells() const {
    return target.kind == ShrinkWrapKind::Continuum  ? w.cells
           : target.kind == ShrinkWrapKind::Oriented ? w.oriented.cells
                                                     : w.sheets.cells;
  }
  std::size_t owned() const {
    return target.kind == ShrinkWrapKind::Continuum  ? w.particles.owned
           : target.kind == ShrinkWrapKind::Oriented ? w.oriented.rows.owned
                                                     : w.sheets.rows.owned;
  }
  bool has(std::size_t j) const {
    return (target.kind == ShrinkWrapKind::Continuum  ? w.particles.body[j]
            : target.kind == ShrinkWrapKind::Oriented ? w.oriented.rows.body[j]
                                                      : w.sheets.rows.body[j]) == target.index;
  }
  Vec3d place(std::size_t j) const {
    return target.kind == ShrinkWrapKind::Continuum  ? w.particles.position[j]
           : target.kind == ShrinkWrapKind::Oriented ? w.oriented.rows.position[j]
                                                     : w.sheets.rows.position[j];
  }
  /// Returns the weight of a row in its cell: its mass (kg), or the area (m^2) of a vertex, because vertices
  /// may be massless.
  double share(std::size_t j) const {
    return target.kind == ShrinkWrapKind::Continuum  ? w.particles.mass[j]
           : target.kind == ShrinkWrapKind::Oriented ? w.oriented.rows.mass[j]
                                                     : w.sheets.rows.area[j];
  }

  void pull(std::size_t j, Vec3d force, double dt) const {
    if (target.kind == ShrinkWrapKind::Continuum) {
      Continuum& p = w.particles;
      p.force[j] += force;
      // includes half of the kick of this force, approximated by the last acceleration
      if (dt > 0) w.ledger.wallWork.add(dt * dot(force, p.velocity[j] + p.acceleration[j] * (0.5 * dt)));
    } else if (target.kind == ShrinkWrapKind::Oriented) {
      Oriented& o = w.oriented.rows;
      if (w.scene.oriented[target.index].planar) force.y = 0;
      o.force[j] += force;
      o.external[j] += force;
      o.dissipativeForce[j] += force;  // shrink-wrap has no stored energy, so its work is recorded as
                                       // dissipation
    } else {
      Sheets& s = w.sheets.rows;
      s.load[j] += force / s.area[j];
      s.outside[j] += force / s.area[j];
    }
  }
};

/// Returns the body's cells on this rank, ascending by key.
std::vector<ShrinkWrapCell> cellsOf(const ShrinkWrapBody& body) {
  std::vector<ShrinkWrapCell> parts;
  const CellTable& t = body.cells();
  for (std::size_t c = 0; c < t.key.size(); c++) {
    if (t.first[c] >= body.owned()) continue;
    ShrinkWrapCell p{t.key[c], 0, {}};
    for (std::size_t j = t.first[c]; j < t.first[c] + t.count[c]; j++)
      if (body.has(j)) {
        p.share += body.share(j);
        p.middle += body.share(j) * body.place(j);
      }
    if (!(p.share > 0)) continue;
    p.middle = p.middle / p.share;
    parts.push_back(p);
  }
  return parts;
}

/// Shrink-wrap forces of one sheet on its target body.
struct ShrinkWrap {
  const SheetView& w;
  std::size_t sheet;
  const std::vector<ShrinkWrapCell>& parts;
  const PointTree& tree;
  double unit;  // N, unit of all forces
  double twoCells;
  std::vector<std::int64_t>& pulls;  // per cell: three components, in units

  /// Returns the force of size `size` (N) on vertex i, in units.
  Vec3<std::int64_t> draw(std::size_t i, double size) {
    const Vec3d x = w.sheets.rows.position[i];
    const double reach = length(parts[tree.nearest(x, 1)[0]].middle - x) + twoCells;
    const std::vector<std::uint32_t> near = tree.within(x, reach);
    Vec3d sum{};
    double sizes = 0;
    const auto weighed = [&](std::uint32_t k) {
      const Vec3d d = parts[k].middle - x;
      const double q = std::max(0.0, 1 - dot(d, d) / (reach * reach));
      return (parts[k].share * q * q) * d;
    };
    for (const std::uint32_t k : near) {
      const Vec3d d = weighed(k);
      sum += d;
      sizes += length(d);
    }
    Vec3<std::int64_t> force{};
    const double per = size / std::max(length(sum), blunt * sizes);
    if (!(sizes > 0)) return force;
    for (const std::uint32_t k : near) {
      const Vec3d term = per * weighed(k);
      for (int a = 0; a < 3; a++) {
        const auto units = static_cast<std::int64_t>(std::llrint(term[a] / unit));
        force[a] += units;
        pulls[3 * k + static_cast<std::size_t>(a)] -= units;
      }
    }
    return force;
  }
};

void wrapSheet(const SheetView& w, Halos halos, const SheetVelocities& now, std::size_t n) {
  SheetBodies& b = w.sheets;
  Sheets& s = b.rows;
  const SheetBody& body = w.scene.sheets[n];
  const FactorsNow& factors = b.factors[n];
  const std::size_t f = placeOf(SheetFactor::ShrinkWrap);
  if (factors.now[f] == 0 && factors.most[f] == 0) return;
  const ShrinkWrapBody wrapped{w, b.plans[n].shrinkWrapTarget};
  const double cell = std::max({w.grid.edge.x, w.grid.edge.y, w.grid.edge.z});
  std::vector<Vec3d> places;
  for (std::size_t i = 0; i < s.owned; i++)
    if (s.body[i] == n) places.push_back(s.position[i]);
  const std::vector<ShrinkWrapCell> cells = cellsOf(wrapped);
  const ShrinkWrapSurface surface = findShrinkWrapSurface(halos.all, w.grid, cells, places, 2 * cell);
  if (!surface.any) return;  // the target body is gone
  const std::vector<ShrinkWrapCell>& parts = surface.near;
  std::vector<Vec3d> middles;
  for (const ShrinkWrapCell& p : parts) middles.push_back(p.middle);
  const PointTree tree(middles);
  double area = 0;
  for (const double a : b.plans[n].topology.area) area += a;
  // the sum of all terms fits into 62 bits
  const double unit = std::ldexp(
      std::exp2(std::ceil(std::log2(area * std::abs(body.shrinkWrap) *
                                    largestFactor(body, SheetFactor::ShrinkWrap) / blunt))),
      -61);
  std::vector<std::int64_t> pulls(3 * parts.size(), 0);
  ShrinkWrap wrap{w, n, parts, tree, unit, 2 * cell, pulls};
  for (std::size_t i = 0; i < s.owned; i++) {
    if (s.body[i] != n) continue;
    const double pressure = body.shrinkWrap * b.laws[s.law[i]].factor[f];
    b.slope[i] += 2 / blunt * std::abs(pressure) * factors.most[f] / cell;  // the direction turns within a
                                                                            // cell
    if (pressure * factors.now[f] == 0) continue;
    const Vec3<std::int64_t> units = wrap.draw(i, pressure * factors.now[f] * s.area[i]);
    const Vec3d load = (unit / s.area[i]) * Vec3d{static_cast<double>(units.x), static_cast<double>(units.y),
                                                  static_cast<double>(units.z)};
    s.load[i] += load;
    s.outside[i] += load;
  }
  const CellTable& t = wrapped.cells();
  for (const ShrinkWrapForce& p : reduceShrinkWrapForces(halos.all, surface, pulls)) {
    const auto c = static_cast<std::size_t>(std::lower_bound(t.key.begin(), t.key.end(), p.key) -
                                            t.key.begin());
    const double share =
        std::lower_bound(cells.begin(), cells.end(), p.key, [](const ShrinkWrapCell& x, std::uint64_t key) {
          return x.key < key;
        })->share;
    const Vec3d force = unit * Vec3d{static_cast<double>(p.units.x), static_cast<double>(p.units.y),
                                     static_cast<double>(p.units.z)};
    for (std::size_t j = t.first[c]; j < t.first[c] + t.count[c]; j++)
      if (wrapped.has(j)) wrapped.pull(j, (wrapped.share(j) / share) * force, now.dt);
  }
}

}  // namespace

void addShrinkWrap(const SheetView& w, Halos halos, const SheetVelocities& now) {
  for (std::size_t n = 0; n < w.sheets.plans.size(); n++)
    if (const ShrinkWrapKind kind = w.sheets.plans[n].shrinkWrapTarget.kind;
        kind != ShrinkWrapKind::Normal && kind != ShrinkWrapKind::Obstacle)
      wrapSheet(w, halos, now, n);
}

}  // namespace thaw
