// SPDX-License-Identifier: Apache-2.0
#include "core/walls/wall_forces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/contact/dashpot.hpp"
#include "core/contact/friction_spring.hpp"
#include "core/fluid/flow_laws/particle_viscosity.hpp"
#include "core/fluid/laws/particle_pressure.hpp"
#include "core/materials/contact_modulus.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/materials/rest_density.hpp"
#include "core/particles/elastic_pieces.hpp"
#include "core/particles/sleep_stage.hpp"
#include "core/walls/wall_load.hpp"
#include "core/walls/wall_offsets.hpp"
#include "core/walls/wall_surface_energy.hpp"

namespace thaw {
namespace {

/// Limits a decay rate r (1/s) for a step dt (s). It is unchanged up to r dt = 1/2, and reduced beyond,
/// so that it never overshoots. The exact average over the step, (1 - exp(-r dt)) / dt, is not used. The
/// forces of neighbours are not averaged. The average would thus be too low by a fraction r dt / 2, about a
/// tenth. The liquid would then slip.
double overStep(double r, double dt) {
  const double share = r * dt;
  return share > 0.5 ? (1 - 0.5 * std::exp(1 - 2 * share)) / dt : r;
}

/// Forces of walls on one particle.
struct WallAction {
  Vec3d force{};             ///< N, total
  Vec3d dissipativeForce{};  ///< N, dissipative part: drag, dashpot, friction
  double lost = 0;           ///< W, loss by dissipativeForce at the half-step velocity
  void resist(const Vec3d& f, const Vec3d& u) {
    force += f;
    dissipativeForce += f;
    lost -= dot(f, u);
  }
};

/// A particle relative to one wall.
struct ParticleAtWall {
  const WallContact& contact;
  const Obstacle& wall;
  const Material& material;
  double density;  ///< kg/m^3, at rest
  std::size_t row;
  double liquid;   ///< liquid fraction
  double volume;   ///< m^3, rest volume
  Vec3d velocity;  ///< m/s, relative to the wall
};

/// Force (N) along the normal: the wall's part of the hydrostatic pressure gradient. The wall's push uses the
/// particle's own pressure, but liquid in place of the wall would have a pressure that increases with depth.
/// The wall's part is its share of the particle's moment. The force is 0 without positive pressure, as in
/// falling drops.
double hydrostaticWallForce(const Scene& scene, const ParticleAtWall& at, double pressure,
                            double momentShare) {
  constexpr double depth = 0.25;  // spacings of pressure head; the force fades below it
  const double weight = at.density * dot(scene.domain.gravity, at.contact.normal);
  const double full = std::abs(weight) * depth * scene.spacing;
  if (!(pressure > 0 && full > 0)) return 0;
  return -weight * at.volume * momentShare * at.contact.share * (pressure / (pressure + full));
}

/// Adds the pressure of a liquid, the gradient of its compression energy (tables.hpp), and drag.
void addLiquidForces(const WallContext& x, const ParticleAtWall& at, double inverseLatticeSum,
                     WallAction& act, double& stiffest) {
  const WallView& w = x.world;
  const Continuum& p = w.particles;
  const double h = w.grid.support;
  const WallIntegrals t = x.tables(at.contact.distance / h);
  const double relativeDensity = static_cast<double>(p.relativeDensity[at.row]);
  const double pressure = w.modules.incompressible ? 0
                                                   : static_cast<double>(pressureOfParticle(
                                                         w.scene, w.modules, p, x.liquids, at.row));
  const Vec3d& n = at.contact.normal;
  if (pressure != 0 && relativeDensity > 0) {
    const double term = w.scene.numerics.pressure == PairForm::Printed
                            ? 0.5 * pressure / relativeDensity
                            : inverseLatticeSum * pressure / (relativeDensity * relativeDensity);
    act.force += n * (at.volume * term * t.push / h * at.contact.share);
    // This force has no potential: its work is dissipation.
    if (w.modules.continuity)
      act.resist(n * hydrostaticWallForce(w.scene, at, pressure, inverseLatticeSum * t.momentShare),
                 at.velocity);
    stiffest = std::max(stiffest, x.liquids[p.material[at.row]].soundSpeed *
                                      soundSpeedFactor(w.scene.numerics.eos, relativeDensity) *
                                      inverseLatticeSum * t.push / h);
  }
  if (w.modules.surfaceEnergy && !w.modules.contactAngle)
    act.force += n * surfaceForceOfWall(w.scene, w.grid, p, at.contact);
  if (at.wall.slip || w.modules.implicitViscosity) return;
  const double m = p.mass[at.row], rate = m * overStep(wallDrag(x, at.contact) / m, x.span);
  const Vec3d tangential = at.velocity - n * dot(at.velocity, n);
  act.resist(tangential * -rate, at.velocity);
}

/// Adds a spring with dashpot (CS79) and friction. Its energy goes to `stored` if that is not null. Returns
/// true if a solid is pressed. shear (m): displacement of the friction spring; null: no spring, friction
/// is a drag at low speed.
bool addContactForces(const WallContext& x, const ParticleAtWall& at, Continuum* stored, WallAction& act,
                      Vec3d* shear) {
  const Continuum& p = x.world.particles;
  if (at.contact.distance >= longestSpring * x.world.scene.spacing) return false;
  const double f = at.liquid, m = p.mass[at.row];
  const WallSpring wall = wallSpring(x, at.row);
  const double gap = wall.length - at.contact.distance, k = wall.stiffness;
  if (gap <= 0 || k <= 0) return false;
  const Vec3d& n = at.contact.normal;
  const double restitution = f < 1 ? std::min(at.wall.restitution, at.material.restitution) : 0.2;
  const double un = dot(at.velocity, n), spring = k * gap;
  // A contact never pulls.
  const double dash = std::max(-2 * dashpotRatio(restitution) * std::sqrt(k * m) * un, -spring);
  act.force += n * spring;
  act.resist(n * dash, at.velocity);
  if (stored) stored->interaction[at.row] += 0.5 * k * gap * gap;
  if (f >= 1) return false;
  // Upper limit of the friction rate. Friction then does not stop the sliding within the step (or the
  // spring's period), so it never reverses the motion.
  const double stick = std::min(std::sqrt(k * m), 0.5 * m / x.span);
  const SpringFriction friction = springFriction(
      {k, (1 - f) * stick, (1 - f) * at.wall.friction * (spring + dash)}, n,
      shear ? *shear + at.velocity * x.dt : Vec3d{}, at.velocity);
  if (shear) *shear = friction.shear;
  act.resist(friction.spring + friction.dashpot, at.velocity);
  return true;
}

/// Friction spring of a particle. It acts at the first wall that presses the particle.
class FrictionSpring {
 public:
  FrictionSpring(Continuum& p, std::size_t row, double dt, const Material& material)
      : p_(p), row_(row), kept_(p.wallShear.active && keepsSurface(material)), stepped_(dt > 0) {
    if (kept_) shear_ = wide(p.wallShear[row]);
  }
  /// The spring for the next contact, or null.
  Vec3d* forContact() { return kept_ && !used_ ? &shear_ : nullptr; }
  void note(bool pressed) { used_ = used_ || pressed; }
  /// Stores the displacement, 0 without contact. Does not change it in an evaluation
  /// outside of a step.
  void store() {
    if (kept_ && stepped_) p_.wallShear[row_] = used_ ? single(shear_) : Vec3f{};
  }

 private:
  Continuum& p_;
  std::size_t row_;
  bool kept_, stepped_, used_ = false;
  Vec3d shear_{};
};

/// Velocity difference (m/s) between the force evaluation and the energy change. Half a kick precedes the
/// evaluation and half a kick follows; at the start, only the latter. With Continuum::drag, the pressure
/// solver records the difference, except for substeps.
Vec3d halfKick(const WallContext& x, std::size_t i, bool substeps) {
  const Continuum& p = x.world.particles;
  if ((p.clamped.active && p.clamped[i]) || (p.sleep.active && p.sleep[i] != awake)) return {};
  const double half = x.dt > 0 ? 0.5 * x.dt : 0.25 * x.span;
  Vec3d kick{};
  if (!p.drag.active) kick = (p.force[i] / p.mass[i] + x.world.scene.domain.gravity) * half;
  if (substeps) kick += p.fastAcceleration[i] * ((x.fast - 1) * half);
  return kick;
}

}  // namespace

WallSpring wallSpring(const WallContext& x, std::size_t row) {
  const Continuum& p = x.world.particles;
  const Scene& s = x.world.scene;
  const double dx = s.spacing, f = liquidFraction(p, row);
  const Material& m = s.materials[p.material[row]];
  // The incompressible solver stops liquids at walls (stopAtWalls); the spring of the state equation is too
  // stiff for its steps.
  const double liquid = x.world.modules.incompressible ? 0 : x.liquids[p.material[row]].stiffness;
  // The spring frequency of an evaporating particle is that of a full particle.
  const double filled = x.world.modules.evaporation
                            ? p.mass[row] / (restDensityOf(p, s.materials, row) * dx * dx * dx)
                            : 1;
  double rest = p.contactOffset.active ? static_cast<double>(p.contactOffset[row]) : longestSpring;
  if (p.wallOffset.active && p.wallOffset[row] > 0)
    rest = std::min(rest, static_cast<double>(p.wallOffset[row]));
  WallSpring spring;
  spring.length = dx * (rest + f * (springOfLiquid - rest));
  spring.stiffness = (contactModulus(m, f) + f * liquid) * dx * filled;
  return spring;
}

void recordResistance(const WallContext& x, std::span<const DissipativeForce> dissipativeForce) {
  Continuum& p = x.world.particles;
  for (const DissipativeForce& r : dissipativeForce) {
    if (p.drag.active) p.drag[r.row] += r.force;
    p.dissipation[r.row] -= dot(
        r.force, halfKick(x, r.row, p.fastAcceleration.active && p.solidIndex[r.row] != noSolid));
  }
}

double wallDrag(const WallContext& x, const WallContact& contact) {
  const WallView& w = x.world;
  const Continuum& p = w.particles;
  const std::size_t i = contact.row;
  const double f = liquidFraction(p, i), h = w.grid.support;
  if (f == 0 || w.walls.list[contact.wall].properties.slip) return 0;
  const Material& m = w.scene.materials[p.material[i]];
  const double mu = viscosityOfParticle(m, p, i, f);
  return f * mu * restVolumeOf(p, w.scene.materials, i) * x.tables(contact.distance / h).drag *
         contact.share / (h * h);
}

void addWallForces(const WallContext& x, double inverseLatticeSum, WallContacts& contacts) {
  const WallView& w = x.world;
  Continuum& p = w.particles;
  const auto& list = contacts.list;
  for (ExactSum& s : contacts.fast) s = {};
  contacts.stiffest = 0;
  const WallContext shorter{w, x.tables, x.liquids, x.dt * x.fast, x.span * x.fast};
  for (std::size_t c = 0; c < list.size();) {
    const std::uint32_t i = list[c].row;
    if (x.sleeps(i) || touchesAsPiece(p, i)) {  // rigid pieces have their own contacts (core/rigid/)
      c++;
      continue;
    }
    const Material& m = w.scene.materials[p.material[i]];
    const double density = restDensityOf(p, w.scene.materials, i);
    const bool substeps = p.fastAcceleration.active && p.solidIndex[i] != noSolid;
    WallAction act, often;  // often: the part that substeps apply
    FrictionSpring friction(p, i, x.dt, m);
    for (; c < list.size() && list[c].row == i; c++) {
      const Wall& wall = w.walls.list[list[c].wall];
      const Vec3d v = wallVelocity(wall, p.position[i]), before = act.force;
      const ParticleAtWall at{
          list[c],          wall.properties, m, density, i, liquidFraction(p, i), p.mass[i] / density,
          p.velocity[i] - v};
      if (at.liquid > 0) addLiquidForces(x, at, inverseLatticeSum, act, contacts.stiffest);
      const WallAction slow = act;
      friction.note(addContactForces(substeps ? shorter : x, at, &p, act, friction.forContact()));
      if (substeps) {
        often.force += act.force - slow.force;
        often.dissipativeForce += act.dissipativeForce - slow.dissipativeForce;
        often.lost += act.lost - slow.lost;
      }
      if (wall.properties.motion.empty()) continue;
      w.ledger.wallWork.add(dot(act.force - before, v) * x.dt);
      if (substeps) w.ledger.wallWork.add(dot(act.force - slow.force, v) * (x.dt * (x.fast - 1)));
    }
    friction.store();
    p.force[i] += act.force;
    if (substeps) p.fastAcceleration[i] += often.force / p.mass[i];
    if (p.drag.active) p.drag[i] += act.dissipativeForce;
    const Vec3d half = halfKick(x, i, substeps);
    p.dissipation[i] += act.lost - dot(act.dissipativeForce, half);
    for (int a = 0; a < 3; a++) w.ledger.wallForce[a].add(act.force[a]);
    if (!substeps) continue;
    p.dissipation[i] += (x.fast - 1) * (often.lost - dot(often.dissipativeForce, half));
    for (int a = 0; a < 3; a++) {
      contacts.fast[a].add(often.force[a]);
      w.ledger.wallForce[a].add(often.force[a] * (x.fast - 1));
    }
  }
}

WallLoad wallLoad(const WallContext& x, double inverseLatticeSum, const WallContacts& contacts,
                  std::size_t wall) {
  const WallView& w = x.world;
  const Continuum& p = w.particles;
  WallLoad load;
  const WallContext still{w, x.tables, x.liquids, 0, x.span};  // with dt = 0, friction springs keep their
                                                               // displacement
  std::optional<FrictionSpring> friction;                      // spring of the current row
  std::size_t row = w.particles.owned;
  for (const WallContact& c : contacts.list) {
    const Wall& touched = w.walls.list[c.wall];
    const std::size_t i = c.row;
    if (touchesAsPiece(p, i)) continue;
    if (i != row) friction.emplace(w.particles, i, 0, w.scene.materials[p.material[i]]);
    row = i;
    const double density = restDensityOf(p, w.scene.materials, i);
    const ParticleAtWall at{c,
                            touched.properties,
                            w.scene.materials[p.material[i]],
                            density,
                            i,
                            liquidFraction(p, i),
                            p.mass[i] / density,
                            p.velocity[i] - wallVelocity(touched, p.position[i])};
    WallAction act;
    double stiffest = 0;
    friction->note(addContactForces(still, at, nullptr, act, friction->forContact()));
    if (touched.originalAt(c.wall) != wall) continue;
    if (at.liquid > 0) addLiquidForces(x, at, inverseLatticeSum, act, stiffest);
    const Vec3d torque = cross(p.position[i] - touched.pose.move, act.force);
    for (int a = 0; a < 3; a++) {
      load.force[a].add(-act.force[a]);
      load.torque[a].add(-torque[a]);
    }
  }
  return load;
}

void recordClamps(const WallContext& x, WallContacts& contacts) {
  const WallView& w = x.world;
  const Continuum& p = w.particles;
  if (!p.clamped.active) return;
  const Vec3d g = w.scene.domain.gravity;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.clamped[i]) {
      Vec3d balance = -(p.force[i] + g * p.mass[i]);
      if (p.fastAcceleration.active) {
        const Vec3d often = p.fastAcceleration[i] * -p.mass[i];
        for (int a = 0; a < 3; a++) contacts.fast[a].add(often[a]);
        balance += often * (x.fast - 1);
      }
      for (int a = 0; a < 3; a++) w.ledger.wallForce[a].add(balance[a]);
      if (p.clamped[i] == driven) w.ledger.wallWork.add(dot(balance, p.velocity[i]) * x.dt);
    }
}

void addSubstepContacts(const WallContext& x, std::vector<WallContact>& contacts) {
  const WallView& w = x.world;
  Continuum& p = w.particles;
  for (std::size_t c = 0; c < contacts.size();) {
    const std::uint32_t i = contacts[c].row;
    const Material& m = w.scene.materials[p.material[i]];
    const double density = restDensityOf(p, w.scene.materials, i);
    WallAction act;
    FrictionSpring friction(p, i, x.dt, m);
    for (; c < contacts.size() && contacts[c].row == i; c++) {
      if (!followContact(p, w.scene, w.walls, contacts[c])) continue;
      const Wall& wall = w.walls.list[contacts[c].wall];
      const Vec3d v = wallVelocity(wall, p.position[i]), before = act.force;
      friction.note(addContactForces(x,
                                     {contacts[c], wall.properties, m, density, i, liquidFraction(p, i),
                                      p.mass[i] / density, p.velocity[i] - v},
                                     &p, act, friction.forContact()));
      if (!wall.properties.motion.empty()) w.ledger.wallWork.add(dot(act.force - before, v) * x.dt);
    }
    friction.store();
    Vec3d& force = w.solids.force[p.solidIndex[i]];
    force += act.force;
    const Vec3d half = p.clamped.active && p.clamped[i] ? Vec3d{} : force * (0.5 * x.dt / p.mass[i]);
    p.dissipated[i] += (act.lost - dot(act.dissipativeForce, half)) * x.dt;
    for (int a = 0; a < 3; a++) w.ledger.wallImpulse[a].add(act.force[a] * x.dt);
  }
}

void addWallHeat(const WallContext& x, const WallContacts& contacts) {
  const WallView& w = x.world;
  Continuum& p = w.particles;
  const double h = w.grid.support;
  const HeatModel model = w.scene.numerics.heat;
  for (const WallContact& c : contacts.list) {
    const WallIntegrals t = x.tables(c.distance / h);
    const Obstacle& o = w.walls.list[c.wall].properties;
    if (!o.temperature || x.sleeps(c.row)) continue;
    const Material& m = w.scene.materials[p.material[c.row]];
    const double f = liquidFraction(p, c.row), k = conductivityOf(model, m, f),
                 V = restVolumeOf(p, w.scene.materials, c.row);
    if (k <= 0) continue;
    double conductance = k * V * t.conduct * c.heatShare / (h * h);  // W/K
    if (o.conductance < never)
      conductance *= o.conductance / (o.conductance + k / std::max(c.distance, x.tables.nearest * h));
    const double capacity = p.mass[c.row] * heatCapacityOf(model, m, f);
    const double flow = overStep(conductance / capacity, x.span) * capacity *
                        (*o.temperature - p.temperature[c.row]);
    p.heatFlow[c.row] += flow;
    w.ledger.heatIn.add(flow * x.dt);
  }
}

}  // namespace thaw
