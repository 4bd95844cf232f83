// SPDX-License-Identifier: Apache-2.0
#include "core/walls/vanished_walls.hpp"

#include <algorithm>

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/fluid/pair_sums/records.hpp"
#include "core/particles/elastic_pieces.hpp"
#include "core/walls/wall_surface_energy.hpp"

namespace thaw {
namespace {

bool vanished(const Wall& w, double since) { return !w.present && since < w.properties.until; }

/// A particle with its contacts before or after the walls vanish.
struct ParticleContacts {
  std::uint32_t row;
  WallSpring spring;
  std::span<const WallContact> list;
};

/// Returns the part of a particle's stored energy (J) that depends on these contacts. added: as for
/// wallRelativeDensity.
double energyWith(const WallContext& x, const LiquidMeasure& measure, const ParticleContacts& contacts,
                  std::vector<double>& added) {
  const WallView& w = x.world;
  const Continuum& p = w.particles;
  const Modules& m = w.modules;
  const std::uint32_t i = contacts.row;
  double energy = 0;
  if (!touchesAsPiece(p, i))
    for (const WallContact& c : contacts.list) energy += contacts.spring.energy(c.distance);
  const double f = liquidFraction(p, i);
  if (m.fluid && !m.continuity) {
    const double walls = wallRelativeDensity({x.tables, w.grid.support}, contacts.list, added);
    const auto summed = static_cast<float>(static_cast<double>(p.relativeDensity[i]) +
                                           measure.inverseLatticeSum * walls);
    energy += compressionAt({w.scene, m, w.grid, x.liquids}, p, i, f, static_cast<double>(summed));
  }
  if (m.surfaceEnergy) energy += surfaceEnergyWith({w, measure.surface}, i, contacts.list);
  return energy;
}

}  // namespace

bool someVanished(const Walls& walls, double since) {
  return std::any_of(walls.list.begin(), walls.list.end(), [&](const Wall& w) { return vanished(w, since); });
}

void findVanished(const WallContext& x, double since, VanishedWalls& v) {
  v.walls = x.world.walls;
  for (Wall& w : v.walls.list) w.present = w.present || vanished(w, since);
  const WallView& w = x.world;
  WallContext before{
      {w.scene, w.modules, w.grid, w.particles, w.cells, w.solids, v.walls, w.ledger, w.counters},
      x.tables,
      x.liquids,
      x.dt,
      x.span,
      x.fast,
      x.steady};
  findWallContacts(before, v.contacts);
  v.springs.clear();
  for (WallContact& c : v.contacts.list) {
    v.springs.push_back(wallSpring(x, c.row));
    const Wall& wall = v.walls.list[c.wall];
    if (!vanished(w.walls.list[c.wall], since)) continue;
    const Vec3d velocity = w.particles.velocity[c.row] - wallVelocity(wall, w.particles.position[c.row]);
    c.distance -= 0.5 * x.dt * dot(velocity, c.normal);
  }
}

void recordVanished(const WallContext& x, const LiquidMeasure& measure, VanishedWalls& v,
                    const WallContacts& now) {
  if (x.world.modules.tensionTable) updateSurfaceTension(x.world);
  const auto& list = v.contacts.list;
  std::vector<double> added;
  for (std::size_t begin = 0, end; begin < list.size(); begin = end) {
    for (end = begin; end < list.size() && list[end].row == list[begin].row;) end++;
    const std::uint32_t i = list[begin].row;
    const ParticleContacts old{i, v.springs[begin], std::span(list).subspan(begin, end - begin)};
    const ParticleContacts remaining{i, wallSpring(x, i), contactsOf(now, i)};
    const double before = energyWith(x, measure, old, added),
                 after = energyWith(x, measure, remaining, added);
    if (after != before) x.world.ledger.wallWork.add(after - before);
  }
}

}  // namespace thaw
