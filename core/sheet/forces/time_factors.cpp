// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/forces/time_factors.hpp"

#include <algorithm>
#include <cmath>

#include "core/sheet/forces/cell_sums.hpp"

namespace thaw {
namespace {

constexpr double growth = 1.1;  // maximum ratio of successive steps (core/simulation/reduce_step.cpp)
// Fractions of a change from zero to the largest factor, per step. The second is a lower limit if an
// oscillation would need shorter steps.
constexpr double partOfChange = 0.04, leastOfChange = 0.001;
constexpr double partOfSwing = 0.25;  // rad, phase of an oscillation per step

double limitOf(const FactorInTime& f, double now, double rate) {
  double limit = never;
  for (std::size_t k = 1; k < f.points.size(); k++) {
    const auto& [t0, f0] = f.points[k - 1];
    const auto& [t1, f1] = f.points[k];
    if (f0 == f1 || !(t1 > now)) continue;
    const double unit = (t1 - t0) * std::max(std::abs(f0), std::abs(f1)) / std::abs(f1 - f0);
    const double part = std::min(partOfChange * unit,
                                 std::max(rate > 0 ? partOfSwing / rate : never, leastOfChange * unit));
    limit = std::min(limit, std::max(t0 - now, part));
  }
  return limit;
}

}  // namespace

double fastestRate(const SheetBody& b, const SpringLaw& l, double from) {
  const double k = l.stiffness * b.inTime[placeOf(SheetFactor::Stiffness)].most(from, never),
               c = l.damping * b.inTime[placeOf(SheetFactor::Damping)].most(from, never);
  if (l.mass > 0) return std::max(std::sqrt(k / l.mass), c / l.mass);
  return c > 0 ? k / c : 0;
}

double timeFactorStepLimit(const SheetBody& b, double now, double swing, double of) {
  double limit = never;
  for (std::size_t f = 0; f < sheetFactors; f++) {
    if (b.inTime[f].points.empty() || !(b.*sheetCoefficients[f].value != 0)) continue;
    const auto kind = static_cast<SheetFactor>(f);
    const bool alone = kind == SheetFactor::Damping || kind == SheetFactor::Stiffness;
    limit = std::min(limit, limitOf(b.inTime[f], now,
                                    alone                                             ? swing
                                    : f >= firstEnergyFactor && f <= lastEnergyFactor ? of
                                                                                      : 0));
  }
  return limit;
}

void updateTimeFactors(SheetBodies& sheets, const Scene& scene, const Clock& clock, double dt) {
  const double time = clock.time + dt, until = time + growth * clock.dt;  // end of the next step
  sheets.factors.resize(scene.sheets.size());
  for (std::size_t n = 0; n < scene.sheets.size(); n++)
    for (std::size_t f = 0; f < sheetFactors; f++) {
      const FactorInTime& in = scene.sheets[n].inTime[f];
      sheets.factors[n].now[f] = in.at(time);
      sheets.factors[n].most[f] = in.most(time, until);
    }
}

void activateTimeFactors(SheetBodies& sheets, const Scene& scene) {
  for (const SheetBody& b : scene.sheets)
    for (std::size_t f = firstEnergyFactor; f <= lastEnergyFactor; f++)
      if (!b.inTime[f].points.empty() && b.*sheetCoefficients[f].value > 0)
        sheets.rows.activate(sheets.rows.changing);
}

void recordFactorWork(SheetBodies& sheets, const Scene& scene, Ledger& ledger, double from, double to) {
  Sheets& s = sheets.rows;
  if (!s.changing.active) return;
  std::vector<std::array<double, sheetFactors>> half(scene.sheets.size());
  for (std::size_t n = 0; n < half.size(); n++)
    for (std::size_t f = 0; f < sheetFactors; f++)
      half[n][f] = 0.5 * (scene.sheets[n].inTime[f].at(to) - scene.sheets[n].inTime[f].at(from));
  addByCell(sheets.cells, s.owned, ledger.wallWork, [&](std::size_t i) {
    double work = 0;
    for (std::size_t f = firstEnergyFactor; f <= lastEnergyFactor; f++)
      work += half[s.body[i]][f] * factorEnergyOf(s, i, static_cast<SheetFactor>(f));
    return work;
  });
}

}  // namespace thaw
