// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/forces/continuum_contact.hpp"

#include <algorithm>
#include <cmath>

#include "core/neighbours/rows_around.hpp"
#include "core/time/frame_times.hpp"

namespace thaw {
namespace {

/// Contact of an oriented particle with a continuum particle. Returns false if they do not touch before the
/// end of the next step. A particle born within reach has only the spring until it is free. The barrier
/// scales with the continuum particle's mass, and would eject a light newborn particle.
struct Pairs {
  OrientedView w;
  double span;
  struct PairContact {
    Touch touch;
    bool within;
  };
  bool meet(std::size_t oriented, std::size_t particle, PairContact& m) const {
    const Oriented& o = w.oriented.rows;
    const Continuum& p = w.particles;
    const OrientedContact& contact = w.work.contacts[o.body[oriented]];
    const Vec3d d = p.position[particle] - o.position[oriented];
    const double r2 = dot(d, d), most = 2 * contact.reach;  // no particle moves farther than 0.1 spacings in
                                                            // a step
    if (!(r2 < most * most) || !(r2 > 0)) return false;
    const double r = std::sqrt(r2), depth = contact.reach - r;
    const Vec3d n = d / r, u = p.velocity[particle] - o.velocity[oriented];
    if (!(depth - 1.1 * span * dot(u, n) > 0) && !(depth > 0)) return false;
    TouchLaw law = contactLaw(contact, p.material[particle], p.mass[particle], span);
    if (o.flags[oriented] & emerging) law.barrier = 0;
    m.within = depth > 0;
    m.touch = m.within ? touchOf(law, depth, n, u) : Touch{{}, 0, {}, slopeAhead(law, depth, dot(u, n))};
    return true;
  }
};

}  // namespace

void addContinuumContact(const OrientedView& w, double dt) {
  Oriented& o = w.oriented.rows;
  Continuum& p = w.particles;
  const Pairs pairs{w, dt > 0 ? dt : nextStep(w.clock)};
  std::vector<double> stiff(std::max(p.owned, o.owned), 0);
  Pairs::PairContact m;
  const Touch& c = m.touch;
  w.work.fastest2 = 0;
  const auto findStiffest = [&](const auto& rows) {
    for (std::size_t i = 0; i < rows.owned; i++)
      w.work.fastest2 = std::max(w.work.fastest2, 2 * stiff[i] / rows.mass[i]);
  };
  eachNear(w.cells, p.owned, w.oriented.cells, [&](std::size_t i, std::size_t j) {
    if (!pairs.meet(j, i, m)) return;
    p.force[i] += c.force;
    p.interaction[i] += 0.5 * c.energy;
    // includes half of the kick of this force, approximated by the last acceleration
    p.dissipation[i] -= dot(c.dissipativeForce, p.velocity[i] + p.acceleration[i] * (0.5 * dt));
    stiff[i] += c.slope;
  });
  findStiffest(p);
  std::fill(stiff.begin(), stiff.end(), 0.0);
  std::vector<std::uint8_t> out(o.owned, 1);
  eachNear(w.oriented.cells, o.owned, w.cells, [&](std::size_t j, std::size_t i) {
    if (!pairs.meet(j, i, m)) return;
    const bool planar = w.scene.oriented[o.body[j]].planar;
    const auto off = [&](Vec3d f) {
      if (planar) f.y = 0;
      return f;
    };
    o.force[j] -= off(c.force);
    o.external[j] -= off(c.force);
    o.dissipativeForce[j] -= off(c.dissipativeForce);
    o.energy[j] += 0.5 * c.energy;
    o.stiffness[j] += 2 * c.slope / o.mass[j];
    stiff[j] += c.slope;
    if (m.within) out[j] = 0;
  });
  for (std::size_t j = 0; j < o.owned; j++)
    if (out[j]) o.flags[j] = static_cast<std::uint8_t>(o.flags[j] & ~emerging);
  findStiffest(o);  // the force is constant over a step, so explicit limits apply to all integrators
}

}  // namespace thaw
