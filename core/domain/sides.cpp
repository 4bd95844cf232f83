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

template<class Rows> void findLeaving(const Domain& d, Rows& p, std::size_t begin, std::size_t end, std::vector<std::uint32_t>& rows) {
  Vec3d low, high;
  for (int a = 0; a < 3; a++) {
    low[a] = d.side[a][0] == Side::Open ? d.min[a] : -HUGE_VAL;
    high[a] = d.side[a][1] == Side::Open ? d.max[a] : HUGE_VAL;
  }
  const Vec3d* position = p.position.data();
  for (std::size_t i = begin; i < end; i++)
    if (const Vec3d x = position[i]; (x.x < low.x) | (x.y < low.y) | (x.z < low.z) | (x.x >= high.x) | (x.y >= high.y) | (x.z >= high.z)) {
      p.nextCell[i] = noCell;  // not its last cell: another rank may own that since the last rebalance
      rows.push_back(static_cast<std::uint32_t>(i));
    }
}

template void findLeaving(const Domain&, Continuum&, std::size_t, std::size_t, std::vector<std::uint32_t>&);
template void findLeaving(const Domain&, KindRows&, std::size_t, std::size_t, std::vector<std::uint32_t>&);

}  // namespace thaw
