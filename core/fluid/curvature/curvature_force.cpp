// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/curvature/curvature_force.hpp"

#include <algorithm>

#include "core/domain/extensions.hpp"
#include "core/fluid/laws/particle_pressure.hpp"
#include "core/materials/surface_tension.hpp"

namespace thaw {

void addCurvatureForce(const CurvatureContext& x) {
  const WallView& w = x.world;
  Continuum& p = w.particles;
  AddedColumn& forces = *tensionForceOf(p);
  const std::vector<SurfaceElement> elements = findSurfaceElements(x);
  for (std::uint32_t i = 0; i < p.owned; i++) {
    double* const kept = forces.row(i);
    std::fill_n(kept, 3, 0.0);
    const SurfaceElement& e = elements[i];
    const double f = p.phase[i] == Liquid ? liquidFraction(p, i) : 0;
    if (!(e.area > 0) || f == 0 || !isFree(p, i)) continue;
    const Material& m = w.scene.materials[p.material[i]];
    const double tension = m.surfaceTensionTable.empty() ? m.surfaceTension
                                                         : surfaceTensionAt(m, p.temperature[i]);
    const Vec3d force = (e.normal * (-tension * e.curvature) + e.tensionGradient) * (f * e.area);
    for (int axis = 0; axis < 3; axis++) kept[axis] = force[axis];
    p.force[i] += force;
  }
}

void recordCurvatureKick(const WallView& w, HalfKick kick, double dt) {
  const Continuum& p = w.particles;
  const double half = 0.5 * dt;
  const Vec3d& g = w.scene.domain.gravity;
  const AddedColumn& forces = *tensionForceOf(p);
  for (std::size_t i = 0; i < p.owned; i++) {
    const double* const kept = forces.row(i);
    const Vec3d f{kept[0], kept[1], kept[2]};
    if (f == Vec3d{}) continue;
    const Vec3d a = kick == HalfKick::First ? p.acceleration[i] : p.force[i] * (1 / p.mass[i]) + g;
    // at the mean velocity of the kick
    w.ledger.wallWork.add(dot(f, p.velocity[i] + a * (0.5 * half)) * half);
    for (int axis = 0; axis < 3; axis++) w.ledger.wallImpulse[axis].add(f[axis] * half);
  }
}

}  // namespace thaw
