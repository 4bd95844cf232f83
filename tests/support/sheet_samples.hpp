// SPDX-License-Identifier: Apache-2.0
// Scenes of one sheet, for tests.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "core/sheet/step_sheets.hpp"
#include "core/simulation/views/views.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {

inline Scene sheetScene(SheetMesh mesh) {
  Scene s = emptyScene(0.05, {-2, -2, -2}, {2, 2, 2});
  s.sheets.emplace_back();
  SheetBody& b = s.sheets.back();
  b.name = "sheet";
  b.mesh = mesh;
  b.spacing = 0.1;
  b.mass = 0.5;
  return s;
}

/// Runs to the end of the scene. Returns the largest energy residual of all steps, relative to the largest
/// term.
inline double worstResidual(Simulation& sim, double end) {
  double most = 0;
  while (sim.w.clock.time < end) {
    EXPECT_TRUE(sim.step());
    if (testing::Test::HasFailure()) return never;
    const LedgerReport ledgerReport = sim.ledgerReport();
    most = std::max(most, std::abs(ledgerReport.energyResidual) / ledgerReport.energyScale);
  }
  return most;
}

/// Sum of all vertices' energies at the current positions.
inline double energyOf(Simulation& sim) {
  sim.w.sheets.rows.resize(sim.w.sheets.rows.owned, 0);
  loadSheets(sheetView(sim.w), sim.halos(), sim.tools.times, 0);
  double sum = 0;
  for (std::size_t i = 0; i < sim.w.sheets.rows.owned; i++) sum += sim.w.sheets.rows.energy[i];
  return sum;
}

/// Bends and stretches the sheets of a scene. Checks the force of every seventh vertex against the
/// gradient of the energy.
inline void expectForcesFromEnergy(const Scene& s, double time = 0) {
  Simulation sim(s);
  sim.w.clock.time = time;
  Sheets& v = sim.w.sheets.rows;
  for (std::size_t i = 0; i < v.owned; i++) {
    const Vec3d x = v.position[i];
    v.position[i] = x + Vec3d{0.03 * std::sin(7 * x.y), 0.02 * std::cos(5 * x.x),
                              0.05 * std::sin(6 * x.x + 3 * x.y)} *
                            0.5;
  }
  energyOf(sim);
  const std::size_t n = v.owned;
  std::vector<Vec3d> force(n);
  double largest = 0;
  for (std::size_t i = 0; i < n; i++) {
    force[i] = v.load[i] * v.area[i];
    largest = std::max(largest, length(force[i]));
  }
  ASSERT_GT(largest, 0);
  for (std::size_t i = 0; i < n; i += 7)
    for (int a = 0; a < 3; a++) {
      const double h = 1e-6, x = v.position[i][a];
      v.position[i][a] = x + h;
      const double up = energyOf(sim);
      v.position[i][a] = x - h;
      const double down = energyOf(sim);
      v.position[i][a] = x;
      EXPECT_NEAR(force[i][a], -(up - down) / (2 * h), 2e-7 * largest) << i << " " << a;
    }
}

}  // namespace thaw::test
