// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/ledger/ledger_rows.hpp"

#include "core/simulation/world/body_types.hpp"

namespace thaw {

void addBodyTypeRow(const World& w, std::size_t kind, std::size_t i, ExactBalance& b) {
  const BodyTypeRows& r = kind == orientedType ? static_cast<const BodyTypeRows&>(w.oriented.rows)
                                               : w.sheets.rows;
  const double m = r.mass[i];
  const Vec3d &x = r.position[i], &v = r.velocity[i];
  Vec3d angular = m * cross(x, v);
  double kinetic = 0.5 * m * dot(v, v);
  if (kind == orientedType) {
    const Oriented& o = w.oriented.rows;
    angular += o.inertia[i] * o.spin[i];
    kinetic += 0.5 * o.inertia[i] * dot(o.spin[i], o.spin[i]);
  }
  b.mass.add(m);
  for (int a = 0; a < 3; a++) {
    b.momentum[a].add(m * v[a]);
    b.angularMomentum[a].add(angular[a]);
  }
  b.kinetic.add(kinetic);
  b.potential.add(-m * dot(w.scene.domain.gravity, x));
  b.elastic.add(r.energy[i]);
}

}  // namespace thaw
