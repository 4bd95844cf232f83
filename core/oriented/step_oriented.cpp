#include "core/oriented/step_oriented.hpp"

#include <cmath>

namespace thaw {

void stepOriented(World& w, Halos, StepTools& t, double dt) {
  Oriented& o = w.oriented.rows;
  for (std::size_t i = 0; i < o.owned; i++) {
    o.position[i] += dt * o.velocity[i] + (0.5 * dt * dt) * w.scene.domain.gravity;
    o.velocity[i] += dt * w.scene.domain.gravity;
  }
  t.times.lap(StepPhase::Oriented);
}

double orientedStepLimit(const World& w) {
  double fastest = 0;
  for (std::size_t i = 0; i < w.oriented.rows.owned; i++) fastest = std::max(fastest, dot(w.oriented.rows.velocity[i], w.oriented.rows.velocity[i]));
  return fastest > 0 ? supportsPerStep * w.grid.support / std::sqrt(fastest) : never;
}

}  // namespace thaw
