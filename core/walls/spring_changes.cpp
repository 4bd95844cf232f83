// SPDX-License-Identifier: Apache-2.0
#include "core/walls/spring_changes.hpp"

#include "core/particles/elastic_pieces.hpp"

namespace thaw {
namespace {

WallSpring springNow(const WallContext& x, std::uint32_t row) {
  return touchesAsPiece(x.world.particles, row) ? WallSpring{} : wallSpring(x, row);
}

/// Distance (m) that a particle moves away from a wall in the next step, or in its first substep.
double comingMove(const WallContext& x, const WallContact& c, const NextStepLengths& next) {
  const WallView& w = x.world;
  const Continuum& p = w.particles;
  const double dt = w.modules.substeps && takesSubsteps(p, c.row) ? next.substep : next.step;
  const Vec3d velocity = p.velocity[c.row] - wallVelocity(w.walls.list[c.wall], p.position[c.row]);
  return dt * dot(velocity + p.acceleration[c.row] * (0.5 * dt), c.normal);
}

}  // namespace

void listSpringStates(const WallContext& x, const WallContacts& contacts, std::vector<SpringState>& springs) {
  springs.clear();
  const WallView& w = x.world;
  const double reach = longestSpring * w.scene.spacing;
  for (const WallContact& c : contacts.list) {
    if (!(c.distance < reach) || (!springs.empty() && springs.back().row == c.row)) continue;
    if (w.scene.materials[w.particles.material[c.row]].melts())
      springs.push_back({c.row, springNow(x, c.row)});
  }
}

void recordSpringChanges(const WallContext& x, const WallContacts& contacts,
                         const std::vector<SpringState>& springs, const NextStepLengths& next) {
  for (const auto& [row, before] : springs) {
    const WallSpring now = springNow(x, row);
    if (now.length == before.length && now.stiffness == before.stiffness) continue;
    for (const WallContact& c : contactsOf(contacts, row)) {
      const double change = now.energy(c.distance) - before.energy(c.distance),
                   weaker = before.force(c.distance) - now.force(c.distance);
      if (change == 0 && weaker == 0) continue;
      x.world.particles.interaction[row] += change;
      x.world.ledger.phaseJump.add(-(change + 0.5 * weaker * comingMove(x, c, next)));
    }
  }
}

}  // namespace thaw
