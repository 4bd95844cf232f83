#include <algorithm>
#include <cmath>

#include "core/contact/dashpot.hpp"
#include "core/oriented/step_oriented.hpp"

namespace thaw {
namespace {

constexpr double restitution = 0.3;

/// Calls use(row of `other`) for rows in the 27 cells around a place, in their order.
template<class Use> void eachAround(const CellGrid& grid, const CellTable& cells, const Vec3d& x, Use&& use) {
  const Vec3i at = cellOf(grid, x);
  for (int dz = -1; dz <= 1; dz++)
    for (int dy = -1; dy <= 1; dy++)
      for (int dx = -1; dx <= 1; dx++) {
        const std::uint64_t key = cellKey({at.x + dx, at.y + dy, at.z + dz});
        const auto it = std::lower_bound(cells.key.begin(), cells.key.end(), key);
        if (it == cells.key.end() || *it != key) continue;
        const std::size_t c = static_cast<std::size_t>(it - cells.key.begin());
        for (std::uint32_t k = cells.first[c]; k < cells.first[c] + cells.count[c]; k++) use(k);
      }
}

struct Touch { Vec3d force{}, resisting{}; double energy = 0, stiffness = 0; };  // on the continuum's; resisting: of the force, what takes energy away

/// Of an oriented particle on one of the continuum; d from the first to the second, u how fast that grows.
Touch touchOf(const Vec3d& d, const Vec3d& u, double far, double k, double mass) {
  Touch t;
  const double r = length(d);
  if (!(r < far) || !(r > 0)) return t;
  const Vec3d n = d / r;
  const double c = 2 * dashpotRatio(restitution) * std::sqrt(k * mass), spring = k * (far - r), apart = dot(u, n);
  const double push = std::max(0.0, spring - c * apart);  // never pulls
  t.force = push * n;
  t.energy = 0.5 * k * (far - r) * (far - r);
  t.resisting = (push - spring) * n;
  t.stiffness = k;
  return t;
}

}  // namespace

void meetContinuum(World& w, StepTools& t, double dt) {
  Oriented& o = w.oriented.rows;
  Continuum& p = w.particles;
  const auto touch = [&](std::size_t oriented, std::size_t particle) {
    const OrientedBody& body = w.scene.oriented[o.body[oriented]];
    const double s = t.oriented.potentials[o.body[oriented]].spacing, mass = orientedMass(body, s);  // its mass, of ghosts too
    return touchOf(p.position[particle] - o.position[oriented], p.velocity[particle] - o.velocity[oriented], 0.55 * (s + w.scene.spacing), body.contact * body.stiffness,
                   mass * p.mass[particle] / (mass + p.mass[particle]));
  };
  t.oriented.fastest2 = 0;
  for (std::size_t i = 0; i < p.owned; i++) {
    double stiff = 0;
    eachAround(w.grid, w.oriented.cells, p.position[i], [&](std::uint32_t j) {
      const Touch c = touch(j, i);
      p.force[i] += c.force;
      p.interaction[i] += 0.5 * c.energy;
      p.dissipation[i] -= dot(c.resisting, p.velocity[i] + p.acceleration[i] * (0.5 * dt));  // half a kick of the last force stands for that of this one
      stiff += c.stiffness;
    });
    t.oriented.fastest2 = std::max(t.oriented.fastest2, 2 * stiff / p.mass[i]);
  }
  for (std::size_t j = 0; j < o.owned; j++) {
    Vec3d force{}, resisting{};
    eachAround(w.grid, w.cells, o.position[j], [&](std::uint32_t i) {
      const Touch c = touch(j, i);
      force -= c.force;
      resisting -= c.resisting;
      o.energy[j] += 0.5 * c.energy;
      o.stiffness[j] += 2 * c.stiffness / o.mass[j];
    });
    if (w.scene.oriented[o.body[j]].planar) force.y = resisting.y = 0;
    o.force[j] += force;
    o.external[j] += force;
    o.resisting[j] += resisting;
  }
}

}  // namespace thaw
