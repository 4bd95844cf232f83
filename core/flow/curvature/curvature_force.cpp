// SPDX-License-Identifier: Apache-2.0
#include "core/flow/curvature/curvature_force.hpp"

#include <algorithm>

#include "core/flow/curvature/closed_surfaces.hpp"
#include "core/flow/curvature/surface_loops.hpp"
#include "core/flow/curvature/thin_cohesion.hpp"
#include "core/fluid/laws/particle_pressure.hpp"
#include "core/terms/extensions.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {
namespace {

/// Returns the forces (N) on liquid due to curvature and tension gradient. A force is at most the tension of
/// both faces of a film times one spacing. This is the force on a particle at the edge of a film.
std::vector<Vec3d> forcesByCurvature(const WallView& w, const std::vector<FreeSurfaceElement>& elements) {
  std::vector<Vec3d> forces(elements.size());
  for (std::uint32_t i = 0; i < elements.size(); i++) {
    const FreeSurfaceElement& e = elements[i];
    if (!(e.area > 0) || w.particles.phase[i] != Liquid) continue;
    const double tension = tensionAt(w, i), most = 2 * tension * w.scene.spacing;
    const double inwards = std::clamp(tension * e.curvature * e.area, -most, most);
    forces[i] = (e.tensionGradient * e.area - e.normal * inwards) *
                (e.resolved * liquidFraction(w.particles, i));
  }
  return forces;
}

/// Removes the part of a force (N) that lifts a particle off a close wall. At the edge of the liquid, the
/// wall bears the normal component of the tension. The edge thus does not pull a drop off its wall.
Vec3d borneByWalls(const CurvatureContext& x, std::uint32_t i, Vec3d force) {
  for (const WallContact& c : contactsOf(x.contacts, i))
    force -= c.normal * (shareOfWall(x, c) * std::max(dot(force, c.normal), 0.0));
  return force;
}

}  // namespace

void addCurvatureForce(const CurvatureContext& x) {
  Continuum& p = x.world.particles;
  AddedColumn& column = *tensionForceOf(p);
  const std::vector<FreeSurfaceElement> elements = findFreeSurface(x);
  std::vector<Vec3d> forces = forcesByCurvature(x.world, elements);
  balanceClosedSurfaces(x, forces);
  addThinCohesion(x, elements, forces);
  for (std::uint32_t i = 0; i < p.owned; i++) {
    double* const kept = column.row(i);
    std::fill_n(kept, 3, 0.0);
    if (p.phase[i] != Liquid || !isFree(p, i)) continue;
    const Vec3d force = borneByWalls(x, i, forces[i]);
    for (int axis = 0; axis < 3; axis++) kept[axis] = force[axis];
    p.force[i] += force;
  }
}

void reuseCurvatureForce(Continuum& p) {
  AddedColumn& column = *tensionForceOf(p);
  for (std::uint32_t i = 0; i < p.owned; i++) {
    double* const kept = column.row(i);
    if (p.phase[i] == Liquid && isFree(p, i)) p.force[i] += Vec3d{kept[0], kept[1], kept[2]};
    else std::fill_n(kept, 3, 0.0);
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
