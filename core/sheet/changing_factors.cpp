#include "core/sheet/changing_factors.hpp"

#include "core/sheet/cell_sums.hpp"

namespace thaw {
namespace {

constexpr double growth = 1.1;  // of a step over the one before at most (core/step.cpp)

}  // namespace

void findFactors(World& w, double dt) {
  const double time = w.clock.time + dt, until = time + growth * w.clock.dt;  // of the next step
  w.sheets.factors.resize(w.scene.sheets.size());
  for (std::size_t n = 0; n < w.scene.sheets.size(); n++)
    for (std::size_t f = 0; f < sheetFactors; f++) {
      const FactorInTime& in = w.scene.sheets[n].inTime[f];
      w.sheets.factors[n].now[f] = in.at(time);
      w.sheets.factors[n].most[f] = in.most(time, until);
    }
}

void activateChanging(World& w) {
  for (const SheetBody& b : w.scene.sheets)
    for (std::size_t f = firstChanging; f <= lastChanging; f++)
      if (!b.inTime[f].points.empty() && b.*sheetCoefficients[f].value > 0) w.sheets.rows.activate(w.sheets.rows.changing);
}

void bookChanging(World& w, double from, double to) {
  Sheets& s = w.sheets.rows;
  if (!s.changing.active) return;
  std::vector<std::array<double, sheetFactors>> half(w.scene.sheets.size());
  for (std::size_t n = 0; n < half.size(); n++)
    for (std::size_t f = 0; f < sheetFactors; f++) half[n][f] = 0.5 * (w.scene.sheets[n].inTime[f].at(to) - w.scene.sheets[n].inTime[f].at(from));
  addByCell(w.sheets.cells, s.owned, w.ledger.wallWork, [&](std::size_t i) {
    double work = 0;
    for (std::size_t f = firstChanging; f <= lastChanging; f++) work += half[s.body[i]][f] * changingOf(s, i, static_cast<SheetFactor>(f));
    return work;
  });
}

}  // namespace thaw
