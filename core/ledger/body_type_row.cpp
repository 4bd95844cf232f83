// SPDX-License-Identifier: Apache-2.0
#include "core/ledger/body_type_row.hpp"

namespace thaw {

void addBodyTypeRow(const BodyTypeRows& r, std::size_t i, const RowRotation& rotation, const Vec3d& gravity,
                    ExactBalance& b) {
  const double m = r.mass[i];
  const Vec3d &x = r.position[i], &v = r.velocity[i];
  const Vec3d angular = m * cross(x, v) + rotation.angularMomentum;
  b.mass.add(m);
  for (int a = 0; a < 3; a++) {
    b.momentum[a].add(m * v[a]);
    b.angularMomentum[a].add(angular[a]);
  }
  b.kinetic.add(0.5 * m * dot(v, v) + rotation.energy);
  b.potential.add(-m * dot(gravity, x));
  b.elastic.add(r.energy[i]);
}

}  // namespace thaw
