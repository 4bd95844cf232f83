// SPDX-License-Identifier: Apache-2.0
// A stiff solid in a liquid: cost and accuracy of substeps.
#include <cmath>

#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {
namespace {

/// No exact solution exists. The measure is the unexplained energy over the kinetic energy of the liquid.
std::vector<Figure> measurePlate(Trial& r) {
  const LedgerReport ledgerReport = reportLedger(r.world, r.tools, r.all);
  return {{"energy residual", std::abs(ledgerReport.energyResidual) / ledgerReport.now.kinetic, 0.01},
          {"elastic energy", ledgerReport.now.elastic / ledgerReport.now.kinetic},
          {"momentum residual", length(ledgerReport.momentumResidual) / length(ledgerReport.gravityImpulse),
           1e-6}};
}

}  // namespace

std::vector<Case> mixedCases() {
  return {{.name = "stiff_in_soft",
           .about = "dam break on a stiff undamped plate: unexplained energy over the kinetic energy",
           .measure = measurePlate}};
}

}  // namespace thaw::accuracy
