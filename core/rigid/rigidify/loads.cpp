// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/rigidify/loads.hpp"

#include "core/solid/elasticity/active_solids.hpp"

namespace thaw {

void compareLoads(const RigidifyView& v) {
  constexpr double unknown = never;  // x component of the load of particles that are not passive
  const Scene& scene = v.rigid.scene;
  Continuum& p = v.rigid.particles;
  const double strain = scene.numerics.rigidify * scene.numerics.sleepAfter,
               area = scene.spacing * scene.spacing;
  for (std::size_t i = 0; i < p.owned; i++) {
    Vec3d& before = p.constraintForce[i];
    if (p.piece[i] == notRigid || p.solidIndex[i] == noSolid || !isPassive(v.elastic, p.solidIndex[i])) {
      before = {unknown, 0, 0};
      continue;
    }
    const Vec3d load = rotated(conjugate(v.rigid.pieces.orientation[p.pieceRow[i]]), p.force[i]);
    if (!(before.x < unknown)) before = load;
    const Vec3d change = load - before;
    const double most = strain * scene.materials[p.material[i]].young.solid * area;
    if (dot(change, change) > most * most) p.restTime[i] = 0;
  }
}

}  // namespace thaw
