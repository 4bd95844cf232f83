// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/monitor/force_terms.hpp"

#include <algorithm>

#include "core/contact/solid_contact.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/time/integrate.hpp"
#include "core/simulation/views/body_contact_view.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {
namespace {

/// Force on `row` summed by `add`.
template<class Add> Vec3d forceOf(Continuum& p, std::size_t row, Add add) {
  std::fill_n(p.force.data(), p.owned, Vec3d{});
  add();
  return p.force[row];
}

}  // namespace

ForceTerms forceTerms(World& w, StepTools& t, std::size_t i) {
  Continuum& p = w.particles;
  const double dt = w.clock.stepDt;
  const std::vector<Vec3d> force(p.force.data(), p.force.data() + p.owned),
      velocity(p.velocity.data(), p.velocity.data() + p.size());
  const Ledger ledger = w.ledger;
  const Counters counters = w.counters;
  Vec3d rest = forceOf(w.particles, w.scene, i);
  ForceTerms f;
  if (p.solidIndex.active && p.solidIndex[i] != noSolid && p.solidIndex[i] < w.solids.owned) {
    f.elastic = length(w.solids.force[p.solidIndex[i]]);
    rest -= w.solids.force[p.solidIndex[i]];
  }
  if (p.outsideForce.active) {
    f.outside = length(p.outsideForce[i]);
    rest -= p.outsideForce[i];
  }
  // Velocities at the force evaluation.
  for (std::size_t k = 0; k < p.owned; k++) p.velocity[k] -= p.acceleration[k] * (0.5 * dt);
  const auto take = [&](double& share, const Vec3d& part) {
    share = length(part);
    rest -= part;
  };
  if (w.modules.contact)
    take(f.contact, forceOf(p, i, [&] {
           addSolidContacts({w.scene, w.grid, w.solids, w.bonds, dt > 0 ? dt : w.clock.dt},
                            t.contact.closePairs, p);
           if (w.modules.bodyContact)
             addBodyContacts(bodyContactView(w, t.contact.bodies, dt > 0 ? dt : w.clock.dt, 0), {});
         }));
  const WallContext walls{wallView(w), t.walls.tables,           t.liquids,
                          dt,          dt > 0 ? dt : w.clock.dt, 1.0 / w.clock.substeps};
  take(f.walls,
       forceOf(p, i, [&] { addWallForces(walls, t.sums.scales.inverseLatticeSum, t.walls.contacts); }));
  if (w.modules.fluid) {
    std::fill_n(p.velocity.data(), p.size(), Vec3d{});  // removes resistance
    packRecords({w.scene, w.modules, w.grid, t.liquids}, p, 0, p.size(), t.sums.records);
    if (p.drag.active) std::fill_n(p.drag.data(), p.owned, Vec3d{});
    if (p.positionForce.active) std::fill_n(p.positionForce.data(), p.owned, Vec3d{});
    take(f.pressure, forceOf(p, i, [&] {
           for (const Part part : {Part::Inner, Part::Boundary}) {
             const PassRows rows = passRows(part, w.neighbours, p.owned, p.size());
             sumForces(w, t, rows);
             sumTerms(w, t, rows);
           }
           if (p.drag.active) addExplicitForces(p);
           if (p.positionForce.active) addPositionForces(p);
         }));
    f.viscosity = length(rest);
    if (w.modules.incompressible && dt > 0)
      f.pressure = std::max(f.pressure, p.mass[i] * length(p.pressureImpulse[i]) / dt);
  }
  std::copy(force.begin(), force.end(), p.force.data());
  std::copy(velocity.begin(), velocity.end(), p.velocity.data());
  w.ledger = ledger;
  w.counters = counters;
  f.weight = p.mass[i] * length(w.scene.domain.gravity);
  f.atWall = std::any_of(t.walls.contacts.list.begin(), t.walls.contacts.list.end(),
                         [&](const WallContact& c) { return c.row == i && c.distance < w.scene.spacing; });
  return f;
}

}  // namespace thaw
