// SPDX-License-Identifier: Apache-2.0
#include "parallel/balance.hpp"

#include <algorithm>

#include "core/neighbours/list_cells.hpp"
#include "core/simulation/body_types/cell_costs.hpp"
#include "core/simulation/redistribute.hpp"

namespace thaw {

namespace {

// Phases whose time is attributed to all particles, to particles in sums over liquids, and to solids.
constexpr std::array ofAll{StepPhase::Drift, StepPhase::Sort,    StepPhase::Search,
                           StepPhase::Walls, StepPhase::Contact, StepPhase::Heat};
constexpr std::array ofLiquids{StepPhase::Density, StepPhase::Forces, StepPhase::Pressure};
constexpr std::array ofSolids{StepPhase::Elastic};

template<class Phases> double secondsOf(const PhaseTimes& t, const Phases& phases) {
  double sum = 0;
  for (const StepPhase p : phases) sum += t[p];
  return sum;
}

/// Cost in s per row, from the time of the phases since the last measurement.
RowCosts costsOf(const World& w, const PhaseTimes& spent) {
  const Continuum& p = w.particles;
  const double n = static_cast<double>(p.owned);
  RowCosts costs;
  forEachBodyType(w, [&](std::size_t type, const BodyTypeRows& r, const CellTable&) {
    costs.bodyType[type] = r.owned > 0
                               ? spent[type == orientedType ? StepPhase::Oriented : StepPhase::Sheet] /
                                     static_cast<double>(r.owned)
                               : 0;
  });
  if (p.owned == 0) {
    costs.liquid = costs.solid = 0;
    return costs;
  }
  const double solids = static_cast<double>(std::count(p.phase.data(), p.phase.data() + p.owned, Solid));
  // With heat, a solid far from liquids takes half of a liquid's sums (terms/conduction.hpp). Otherwise only
  // solids near liquids take part.
  const double share = w.modules.heat ? 0.5 : 0.1,
               sums = secondsOf(spent, ofLiquids) / (n - solids + share * solids),
               each = secondsOf(spent, ofAll) / n;
  costs.liquid = each + sums;
  costs.solid = each + share * sums + (solids > 0 ? secondsOf(spent, ofSolids) / solids : 0);
  return costs;
}

}  // namespace

double workOf(const PhaseTimes& t) {
  return secondsOf(t, ofAll) + secondsOf(t, ofLiquids) + secondsOf(t, ofSolids);
}

bool balance(World& w, CellHalo& halo, StepTools& t, WorkMeter& meter) {
  PhaseTimes spent;
  for (std::size_t k = 0; k < stepPhases; k++) spent.seconds[k] = t.times.seconds[k] - meter.seconds[k];
  meter.seconds = t.times.seconds;
  if (!needsOrder(w.modules, w.walls, t.solid)) {  // rows may have left the cells of the last sort
    computeCellKeys(w.grid, w.particles);
    listCells(w.particles, w.cells);
  }
  CellCosts costs = costOfCells(w, costsOf(w, spent));
  for (double& c : costs.cost) c = std::max(1e-12, c);
  bool& moved = t.redistribution.newPartition;
  moved = halo.rebalance(costs.cells, costs.cost, false) || moved;
  return moved;
}

}  // namespace thaw
