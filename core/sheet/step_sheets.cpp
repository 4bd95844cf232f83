#include "core/sheet/step_sheets.hpp"

#include <cmath>

namespace thaw {

void stepSheets(World& w, Halos, StepTools& t, double dt) {
  Sheets& o = w.sheets.rows;
  for (std::size_t i = 0; i < o.owned; i++) {
    o.position[i] += dt * o.velocity[i] + (0.5 * dt * dt) * w.scene.domain.gravity;
    o.velocity[i] += dt * w.scene.domain.gravity;
  }
  t.times.lap(StepPhase::Sheet);
}

double sheetStepLimit(const World& w) {
  double fastest = 0;
  for (std::size_t i = 0; i < w.sheets.rows.owned; i++) fastest = std::max(fastest, dot(w.sheets.rows.velocity[i], w.sheets.rows.velocity[i]));
  return fastest > 0 ? supportsPerStep * w.grid.support / std::sqrt(fastest) : never;
}

}  // namespace thaw
