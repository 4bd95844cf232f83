#include "core/watch/sunken.hpp"

#include <cmath>

#include "core/neighbours/rows_around.hpp"

namespace thaw {
namespace {

constexpr double inside = 0.7;  // of the kernel

/// 1/m^3, cubic spline of a support of two spacings: over the places of a lattice its sum is the lattice's 1/s^3 to 1 %.
double kernelOf(double r, double s) {
  const double q = r / s, far = 2 - q;
  if (!(q < 2)) return 0;
  return (q < 1 ? 1 - q * q * (1.5 - 0.75 * q) : 0.25 * far * far * far) / (3.14159265358979323846 * s * s * s);
}

}  // namespace

std::vector<Sunken> findSunken(World& w, Halos halos) {
  const std::size_t bodies = w.scene.bodies.size();
  Continuum& p = w.particles;
  const Oriented& o = w.oriented.rows;
  halos.cells.beginRefresh(p, ColumnList{&p.phase});  // what has melted or frozen since
  halos.cells.finishRefresh(p);
  const double s = w.scene.spacing, volume = s * s * s;
  std::vector<std::int64_t> count(w.scene.oriented.size() * bodies, 0);
  std::vector<RowRange> ranges;
  std::vector<double> full(bodies);
  for (std::size_t c = 0; c < w.oriented.cells.key.size(); c++) {
    const CellTable& cells = w.oriented.cells;
    if (cells.first[c] >= o.owned) continue;
    rowsAround(w.cells, cells.key[c], ranges);
    if (ranges.empty()) continue;
    for (std::uint32_t i = cells.first[c]; i < cells.first[c] + cells.count[c]; i++) {
      std::fill(full.begin(), full.end(), 0.0);
      for (const RowRange& r : ranges)
        for (std::uint32_t j = r.begin; j < r.end; j++)
          if (p.phase[j] == Solid && p.body[j] < bodies) full[p.body[j]] += volume * kernelOf(length(p.position[j] - o.position[i]), s);
      for (std::size_t b = 0; b < bodies; b++) count[o.body[i] * bodies + b] += full[b] > inside;
    }
  }
  halos.all.sum(count);
  std::vector<Sunken> found;
  for (std::size_t k = 0; k < count.size(); k++)
    if (count[k] > 0) found.push_back({k / bodies, k % bodies, count[k]});
  return found;
}

}  // namespace thaw
