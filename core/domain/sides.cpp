// SPDX-License-Identifier: Apache-2.0
#include "core/domain/sides.hpp"

#include <cmath>

#include "core/ledger/counters.hpp"
#include "core/particles/body_type_rows.hpp"

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

OpenBox openBox(const Domain& d) {
  OpenBox box;
  for (int a = 0; a < 3; a++) {
    box.low[a] = d.side[a][0] == Side::Open ? d.min[a] : -HUGE_VAL;
    box.high[a] = d.side[a][1] == Side::Open ? d.max[a] : HUGE_VAL;
  }
  return box;
}

bool hasOpenSide(const Domain& d) {
  bool open = false;
  for (const auto& side : d.side) open = open || side[0] == Side::Open || side[1] == Side::Open;
  return open;
}

void countLeaving(const Domain& d, const Vec3d& x, Counters& counters) {
  std::int64_t* through = nullptr;
  double farthest = -HUGE_VAL;
  for (int a = 0; a < 3; a++)
    for (int high = 0; high < 2; high++) {
      const double beyond = high ? x[a] - d.max[a] : d.min[a] - x[a];
      if (d.side[static_cast<std::size_t>(a)][static_cast<std::size_t>(high)] == Side::Open &&
          beyond > farthest)
        farthest = beyond, through = &counters.leftThrough[a][high];
    }
  counters.left++;
  if (through) ++*through;
}

template<class Rows>
void findLeaving(const Domain& d, Rows& p, std::size_t begin, std::size_t end,
                 std::vector<std::uint32_t>& rows) {
  const OpenBox box = openBox(d);
  const Vec3d* position = p.position.data();
  for (std::size_t i = begin; i < end; i++)
    if (box.leaves(position[i])) {
      p.nextCell[i] = noCell;  // its last cell may belong to another rank since the last rebalance
      rows.push_back(static_cast<std::uint32_t>(i));
    }
}

template void findLeaving(const Domain&, Continuum&, std::size_t, std::size_t, std::vector<std::uint32_t>&);
template void findLeaving(const Domain&, BodyTypeRows&, std::size_t, std::size_t,
                          std::vector<std::uint32_t>&);

}  // namespace thaw
