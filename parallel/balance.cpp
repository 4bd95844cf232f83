#include "parallel/balance.hpp"

#include <algorithm>

#include "core/kinds/cell_costs.hpp"
#include "core/neighbours/list_cells.hpp"
#include "core/bring_home.hpp"

namespace thaw {

double workOf(const PhaseTimes& t) {
  double sum = 0;
  for (StepPhase p : {StepPhase::Drift, StepPhase::Sort, StepPhase::Search, StepPhase::Density, StepPhase::Forces, StepPhase::Pressure, StepPhase::Walls, StepPhase::Contact, StepPhase::Elastic, StepPhase::Heat})
    sum += t[p];
  return sum;
}

bool balance(World& w, CellHalo& halo, StepTools& t, WorkMeter& meter) {
  const auto per = [](double seconds, double& before, std::size_t rows) {
    const double spent = seconds - before;
    before = seconds;
    return rows > 0 ? spent / static_cast<double>(rows) : 0;
  };
  const double perParticle = per(workOf(t.times), meter.seconds, w.particles.owned);
  std::array<double, kindCount> perRow{};
  eachKind(w, [&](std::size_t kind, const KindRows& r, const CellTable&) { perRow[kind] = per(t.times[kind == orientedKind ? StepPhase::Oriented : StepPhase::Sheet], meter.kinds[kind], r.owned); });
  if (!needsOrder(w, t)) {  // rows may have left the cells of the last sort
    computeCellKeys(w.grid, w.particles);
    listCells(w.particles, w.cells);
  }
  CellCosts costs = costOfCells(w, perParticle, perRow);
  for (double& c : costs.cost) c = std::max(1e-12, c);
  t.newPartition = halo.rebalance(costs.cells, costs.cost, false) || t.newPartition;
  return t.newPartition;
}

}  // namespace thaw
