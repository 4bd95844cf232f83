// SPDX-License-Identifier: Apache-2.0
#include "core/flow/curvature/curvature_force.hpp"

#include <algorithm>

#include "core/domain/extensions.hpp"
#include "core/fluid/laws/particle_pressure.hpp"

namespace thaw {

void addCurvatureForce(const CurvatureContext& x) {
  const WallView& w = x.world;
  Continuum& p = w.particles;
  AddedColumn& forces = *tensionForceOf(p);
  const std::vector<FreeSurfaceElement> elements = findFreeSurface(x);
  for (std::uint32_t i = 0; i < p.owned; i++) {
    double* const kept = forces.row(i);
    std::fill_n(kept, 3, 0.0);
    const FreeSurfaceElement& e = elements[i];
    const double f = p.phase[i] == Liquid ? liquidFraction(p, i) : 0;
    if (!(e.area > 0) || f == 0 || !isFree(p, i)) continue;
    const Vec3d force = (e.normal * (-tensionAt(w, i) * e.curvature) + e.tensionGradient) * (f * e.area);
    for (int axis = 0; axis < 3; axis++) kept[axis] = force[axis];
    p.force[i] += force;
  }
}

void recordCurvatureKick(const WallView& w, HalfKick kick, double dt) {
  const Continuum& p = w.particles;
  const AddedColumn& forces = *tensionForceOf(p);
  const KickOfForce force{kick, w.scene.domain.gravity, dt};
  for (std::size_t i = 0; i < p.owned; i++) {
    const double* const kept = forces.row(i);
    if (const Vec3d f{kept[0], kept[1], kept[2]}; !(f == Vec3d{})) force.record(p, i, f, w.ledger);
  }
}

}  // namespace thaw
