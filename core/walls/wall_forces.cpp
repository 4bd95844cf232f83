#include "core/walls/wall_forces.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {
namespace {

double liquidFraction(const Continuum& p, std::size_t i) { return p.liquid.active ? static_cast<double>(p.liquid[i]) : p.phase[i] == Liquid ? 1 : 0; }

bool near(const Wall& w, const Vec3d& x, double reach) {
  for (int a = 0; a < 3; a++)
    if (x[a] < w.bounds.min[a] - reach || x[a] > w.bounds.max[a] + reach) return false;
  return true;
}

double dashpotRatio(double restitution) {
  if (restitution >= 1) return 0;
  const double l = std::log(std::max(restitution, 1e-3));
  return -l / std::sqrt(l * l + 9.869604401089358);
}

/// Averages a decay of rate r (1/s) over the step, so that it never overshoots.
double overStep(double r, double dt) { return dt > 0 && r > 0 ? -std::expm1(-r * dt) / dt : r; }

}  // namespace

void findWallContacts(const WallContext& x, WallContacts& contacts) {
  World& w = x.world;
  Continuum& p = w.particles;
  contacts.list.clear();
  const double h = w.grid.support, deep = 0.5 * w.scene.spacing;
  bool any = false;
  for (const Wall& wall : w.walls.list) any = any || wall.present;
  if (!any) return;
  for (std::size_t i = 0; i < p.owned; i++)
    for (std::size_t k = 0; k < w.walls.list.size(); k++) {
      const Wall& wall = w.walls.list[k];
      if (!wall.present) continue;
      const Vec3d rest = transpose(wall.turn) * (p.position[i] - wall.move);
      if (!near(wall, rest, h)) continue;
      Vec3d n;
      double d = wall.shape->distance(rest, &n);
      if (d >= h) continue;
      n = wall.turn * n;
      if (d < -deep && !(p.clamped.active && p.clamped[i])) {
        const Vec3d u = p.velocity[i] - wallVelocity(wall, p.position[i]);
        const double into = dot(u, n);
        p.position[i] += n * -d;
        if (into < 0) {
          const double before = dot(p.velocity[i], p.velocity[i]);
          p.velocity[i] -= n * into;
          p.dissipated[i] += 0.5 * p.mass[i] * (before - dot(p.velocity[i], p.velocity[i]));
        }
        w.counters.wallProjections++;
        d = 0;
      }
      contacts.list.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k), d, n});
    }
}

void addWallFilling(const WallContext& x, double perLatticeSum, const WallContacts& contacts) {
  Continuum& p = x.world.particles;
  const double h = x.world.grid.support;
  for (std::size_t c = 0; c < contacts.list.size();) {
    const std::uint32_t i = contacts.list[c].row;
    double open = 1;
    for (; c < contacts.list.size() && contacts.list[c].row == i; c++) open *= 1 - x.tables(contacts.list[c].distance / h).filling;
    p.filling[i] = static_cast<float>(static_cast<double>(p.filling[i]) + perLatticeSum * (1 - open));
  }
}

void addWallForces(const WallContext& x, double perLatticeSum, const WallContacts& contacts) {
  World& w = x.world;
  Continuum& p = w.particles;
  const Scene& s = w.scene;
  const double h = w.grid.support, dx = s.spacing;
  for (const WallContact& c : contacts.list) {
    const std::uint32_t i = c.row;
    const Wall& wall = w.walls.list[c.wall];
    const Obstacle& o = wall.properties;
    const Material& m = s.materials[p.material[i]];
    const double f = liquidFraction(p, i), V = p.mass[i] / m.density;
    const Vec3d u = p.velocity[i] - wallVelocity(wall, p.position[i]);
    const double un = dot(u, c.normal);
    const Vec3d tangential = u - c.normal * un;
    Vec3d force{};
    double lost = 0;
    if (f > 0) {
      const WallIntegrals t = x.tables(c.distance / h);
      const double filling = static_cast<double>(p.filling[i]);
      if (p.pressure[i] != 0) force += c.normal * (2 * V * static_cast<double>(p.pressure[i]) / (filling * filling) * perLatticeSum * t.push / h);
      if (!o.slip) {
        const double mu = viscosityAt(m, f, p.temperature.active ? p.temperature[i] : 0);
        const double rate = overStep(f * mu * V * t.drag / (h * h) / p.mass[i], x.dt) * p.mass[i];
        force -= tangential * rate;
        lost += rate * dot(tangential, tangential);
      }
    }
    // spring: of solids from half a spacing on, of liquids, which pressure holds away, as the last resort from a quarter on
    const double d0 = dx * (0.5 - 0.25 * f);
    if (c.distance < d0) {
      const double k = (m.young.at(f) + f * x.liquids[p.material[i]].stiffness) * dx, gap = d0 - c.distance;
      const double restitution = f < 1 ? std::min(o.restitution, m.restitution) : 0.2;
      const double spring = k * gap, cd = 2 * dashpotRatio(restitution) * std::sqrt(k * p.mass[i]);
      const double dash = std::max(-cd * un, -spring), normalForce = spring + dash;
      force += c.normal * normalForce;
      p.interaction[i] += 0.5 * k * gap * gap;
      lost -= dash * un;
      const double slip = length(tangential);
      if (f < 1 && slip > 0) {
        const double stick = std::min(std::sqrt(k * p.mass[i]), x.dt > 0 ? 0.5 * p.mass[i] / x.dt : 0.0) * slip;
        const double rub = (1 - f) * std::min(o.friction * normalForce, stick);
        force -= tangential * (rub / slip);
        lost += rub * slip;
      }
    }
    p.force[i] += force;
    p.dissipation[i] += lost;
    for (int a = 0; a < 3; a++) w.ledger.wallImpulse[a].add(force[a] * x.dt);
    if (!o.motion.empty()) w.ledger.wallWork.add(dot(force, wallVelocity(wall, p.position[i])) * x.dt);
  }
}

void addWallHeat(const WallContext& x, const WallContacts& contacts) {
  World& w = x.world;
  Continuum& p = w.particles;
  const double h = w.grid.support;
  for (const WallContact& c : contacts.list) {
    const Obstacle& o = w.walls.list[c.wall].properties;
    if (!o.temperature) continue;
    const Material& m = w.scene.materials[p.material[c.row]];
    const double f = liquidFraction(p, c.row), k = m.conductivity.at(f), V = p.mass[c.row] / m.density;
    if (k <= 0) continue;
    double conductance = k * V * x.tables(c.distance / h).drag / (h * h);  // W/K
    if (o.conductance < never) conductance *= o.conductance / (o.conductance + k / std::max(c.distance, x.tables.nearest * h));
    const double capacity = p.mass[c.row] * m.heatCapacity.at(f);
    const double flow = overStep(conductance / capacity, x.dt) * capacity * (*o.temperature - p.temperature[c.row]);
    p.heatFlow[c.row] += flow;
    w.ledger.heatIn.add(flow * x.dt);
  }
}

}  // namespace thaw
