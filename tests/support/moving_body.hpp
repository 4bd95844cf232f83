// SPDX-License-Identifier: Apache-2.0
// A solid body (solid_body.hpp) moved by leap-frog, without cells, walls or limits.
#pragma once
#include "tests/support/solid_body.hpp"

namespace thaw::test {

struct MovingBody {
  std::unique_ptr<SolidBody> body;
  std::vector<Vec3d> velocity;
  ElasticResult last;
  MovingBody(const std::vector<Vec3d>& points, const Material& material, const BodyOptions& options = {})
      : body(makeBody(points, {material}, options)), velocity(points.size()) {
    last = computeForces(*body);
  }

  double kinetic() const {
    double e = 0;
    for (std::size_t s = 0; s < velocity.size(); s++)
      e += 0.5 * body->mass[s] * dot(velocity[s], velocity[s]);
    return e;
  }
  void kick(double half) {
    for (std::size_t s = 0; s < velocity.size(); s++)
      velocity[s] += (half / body->mass[s]) * body->solids.force[s];
  }
  void advance(double dt) {
    kick(0.5 * dt);
    for (std::size_t s = 0; s < velocity.size(); s++) body->solids.position[s] += dt * velocity[s];
    if (body->solids.velocity.active)
      std::copy(velocity.begin(), velocity.end(), body->solids.velocity.data());
    body->step.dt = dt;
    last = computeForces(*body);
    kick(0.5 * dt);
  }
  double stepLimit() const {
    return elasticStepLimit(body->scene, std::max(1.0, last.maxStretch2),
                            largestStrainBound(body->work, body->solids));
  }
};

}  // namespace thaw::test
