#include "parallel/balance.hpp"

namespace thaw {

double workOf(const PhaseTimes& t) {
  double sum = 0;
  for (StepPhase p : {StepPhase::Drift, StepPhase::Sort, StepPhase::Search, StepPhase::Density, StepPhase::Forces, StepPhase::Pressure, StepPhase::Walls, StepPhase::Contact, StepPhase::Elastic, StepPhase::Heat})
    sum += t[p];
  return sum;
}

bool balance(World& w, CellHalo& halo, const StepTools& t, WorkMeter& meter) {
  const double now = workOf(t.times), spent = now - meter.seconds;
  meter.seconds = now;
  const double perParticle = w.particles.owned > 0 ? spent / static_cast<double>(w.particles.owned) : 0;
  CellTable own;
  std::vector<double> cost;
  for (std::size_t c = 0; c < w.cells.key.size(); c++) {
    if (w.cells.first[c] >= w.particles.owned) continue;
    own.key.push_back(w.cells.key[c]);
    own.first.push_back(w.cells.first[c]);
    own.count.push_back(w.cells.count[c]);
    cost.push_back(std::max(1e-12, perParticle * w.cells.count[c]));
  }
  own.ownedCells = own.key.size();
  return halo.rebalance(own, cost, false);
}

}  // namespace thaw
