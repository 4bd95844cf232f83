#include "core/domain/sides.hpp"

#include <cmath>

#include "core/kinds/kind_rows.hpp"

namespace thaw {

double wrapPlace(const CellGrid& g, const Domain& d, Vec3d& place) {
  double potential = 0;
  for (int a = 0; a < 3; a++) {
    double& x = place[a];
    if (!g.periodic[a] || (x >= d.min[a] && x < d.max[a])) continue;
    const double before = x;
    x -= g.period[a] * std::floor((x - d.min[a]) / g.period[a]);
    if (x >= d.max[a] || x < d.min[a]) x = d.min[a];  // rounding at the seam
    potential -= d.gravity[a] * (x - before);
  }
  return potential;
}

void wrapPeriodic(const CellGrid& g, const Domain& d, Continuum& p, ExactSum& potential) {
  if (!g.periodic[0] && !g.periodic[1] && !g.periodic[2]) return;
  for (std::size_t i = 0; i < p.owned; i++)
    if (const double more = wrapPlace(g, d, p.position[i]); more != 0) potential.add(p.mass[i] * more);
}

bool isOutside(const Domain& d, const Vec3d& x) {
  bool gone = false;
  for (int a = 0; a < 3; a++) gone = gone || (d.side[a][0] == Side::Open && x[a] < d.min[a]) || (d.side[a][1] == Side::Open && x[a] >= d.max[a]);
  return gone;
}

bool hasOpenSide(const Domain& d) {
  bool open = false;
  for (const auto& side : d.side) open = open || side[0] == Side::Open || side[1] == Side::Open;
  return open;
}

template<class Rows> void findLeaving(const CellGrid&, const Domain& d, Rows& p, std::vector<std::uint32_t>& rows) {
  rows.clear();
  for (std::size_t i = 0; i < p.owned; i++)
    if (isOutside(d, p.position[i])) {
      p.nextCell[i] = noCell;  // not its last cell: another rank may own that since the last rebalance
      rows.push_back(static_cast<std::uint32_t>(i));
    }
}

template void findLeaving(const CellGrid&, const Domain&, Continuum&, std::vector<std::uint32_t>&);
template void findLeaving(const CellGrid&, const Domain&, KindRows&, std::vector<std::uint32_t>&);

}  // namespace thaw
