// SPDX-License-Identifier: Apache-2.0
// Search for particles near walls: first for cells, then for the particles of these cells.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "core/walls/faces.hpp"
#include "core/walls/reachable.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {
namespace {

/// Particles deeper in a wall than this depth (spacings) are moved back to it. Moves all the way out would
/// change the energies of all forces more.
constexpr double deepest = 0.5;

Vec3d restPlace(const Wall& w, const Vec3d& x) { return toRest(w.pose, x); }

/// A particle deep inside a wall.
struct DeepContact {
  std::size_t row;
  double depth;  ///< m
  Vec3d normal;  ///< out of the wall
};

/// Records the contact energy that a particle loses when it is moved out of a wall by `moved` (m). Its
/// velocity into the wall is 0 afterwards, so the half kick at the end of the step does no work. into: m/s,
/// the velocity into the wall before.
void recordContactLoss(const WallContext& x, const DeepContact& c, double moved, double into) {
  Continuum& p = x.world.particles;
  const WallSpring spring = wallSpring(x, c.row);
  const double gap = spring.length + c.depth, left = gap - moved;
  const bool substeps = x.world.modules.substeps && takesSubsteps(p, c.row);
  const double dt = x.dt * (substeps ? x.fast : 1), before = std::max(0.0, gap - into * dt);
  p.dissipated[c.row] += 0.5 * spring.stiffness * (gap * before - left * left);
}

/// Moves a particle out of a wall to the depth `deepest`, and removes its velocity into the wall. Records
/// impulse, work and loss.
Projection project(const WallContext& x, const Wall& wall, const DeepContact& c) {
  const WallView& w = x.world;
  Continuum& p = w.particles;
  const double m = p.mass[c.row], out = c.depth - deepest * w.scene.spacing;
  const Vec3d& n = c.normal;
  p.position[c.row] += n * out;
  w.counters.wallProjections++;
  const Vec3d v = wallVelocity(wall, p.position[c.row]);
  const double into = std::max(0.0, -dot(p.velocity[c.row] - v, n));
  const Vec3d impulse = n * (m * into);
  p.velocity[c.row] += n * into;
  p.dissipated[c.row] += 0.5 * m * into * into;
  for (int a = 0; a < 3; a++) w.ledger.wallImpulse[a].add(impulse[a]);
  w.ledger.wallWork.add(dot(impulse, v));
  recordContactLoss(x, c, out, into);
  return {static_cast<std::uint32_t>(c.row), n * out, n * -into};
}

/// Appends the particle's contacts. May project it out of walls; returns true if it did.
bool listContacts(const WallContext& x, std::size_t i, WallContacts& contacts, bool mayMove) {
  const WallView& w = x.world;
  const double h = w.grid.support, deep = deepest * w.scene.spacing;
  bool moved = false;
  for (const std::uint32_t k : contacts.reachable) {
    const Wall& wall = w.walls.list[k];
    const Vec3d rest = restPlace(wall, w.particles.position[i]);
    if (!nearBounds(wall.bounds, rest, h)) continue;
    const Faces faces = facesWithin(*wall.shape, rest, h, w.scene.spacing);
    if (faces.count == 0) continue;
    const double d = faces.face[0].distance;
    if (mayMove && d < -deep) {
      contacts.projections.push_back(
          project(x, wall, {i, -d, directionFromRest(wall.pose, faces.face[0].normal)}));
      moved = true;
    }
    for (std::size_t f = 0; f < faces.count; f++)
      contacts.list.push_back({static_cast<std::uint32_t>(i), k, faces.face[f].distance,
                               directionFromRest(wall.pose, faces.face[f].normal)});
  }
  return moved;
}

/// Derivative d overlap(a, b) / da of the overlap of two walls that contribute relative densities a and b to
/// a particle. The overlap is exact for two planes through the particle at any angle. It is 0 for opposite
/// planes, and min(a, b) for equal directions (g = 1). The kink of min(a, b) is smoothed.
double overlapSlope(double a, double b, double g) {
  if (g <= 0) return (1 + g) * b;
  return (1 - g) * b + g * b * b / (a * a + b * b + 1e-30);
}

/// Updates the contact offset. A liquid particle may be closer to a wall than the rest distance of solids.
/// Freezing there must not create a compressed spring. The offset is therefore the distance at which the
/// particle froze. It becomes half a spacing once the particle has moved that far. Liquids have no depth
/// below the surface of a solid.
void updateContactOffset(Continuum& p, const Scene& scene, std::size_t i, double nearest) {
  const auto now = static_cast<float>(std::clamp(nearest / scene.spacing, 0.25, 0.5));
  p.contactOffset[i] = p.liquid[i] >= 1 ? now : std::max(p.contactOffset[i], now);
  if (p.contactDepth.active && p.phase[i] == Liquid) p.contactDepth[i] = 0;
}

/// Fraction of a contact's pressure that remains after subtraction of the overlap with another wall.
double shareBeside(const WallSupport& x, const WallContact& c, const WallContact& other) {
  return std::max(
      0.0, 1 - overlapSlope(x.tables(c.distance / x.support).space,
                            x.tables(other.distance / x.support).space, alignment(c.normal, other.normal)));
}

void distributeShares(const WallContext& x, std::span<WallContact> contacts) {
  const auto warm = [&](const WallContact& c) {
    return x.world.walls.list[c.wall].properties.temperature.has_value();
  };
  for (WallContact& c : contacts)
    for (const WallContact& other : contacts) {
      if (&c == &other) continue;
      const double left = shareBeside({x.tables, x.world.grid.support}, c, other);
      c.share *= left;
      if (warm(c) && warm(other)) c.heatShare *= left;
    }
}

}  // namespace

double alignment(const Vec3d& n, const Vec3d& m) {
  return 1 - std::acos(std::clamp(dot(n, m), -1.0, 1.0)) * (2 / std::numbers::pi);
}

std::span<const WallContact> contactsOf(const WallContacts& contacts, std::uint32_t row) {
  const auto before = [](const WallContact& c, std::uint32_t r) { return c.row < r; };
  const auto begin = std::lower_bound(contacts.list.begin(), contacts.list.end(), row, before);
  auto end = begin;
  while (end != contacts.list.end() && end->row == row) ++end;
  return {begin, end};
}

void findWallContacts(const WallContext& x, WallContacts& contacts) {
  const WallView& w = x.world;
  Continuum& p = w.particles;
  contacts.list.clear();
  contacts.projections.clear();
  for (ExactSum& s : w.ledger.wallForce)
    s = {};  // reset here, since surface tension adds to it before all
             // other forces
  bool any = false;
  for (const Wall& wall : w.walls.list) any = any || wall.present;
  if (!any) return;
  const bool freezing = p.contactOffset.active;
  for (std::size_t cell = 0; cell < w.cells.key.size(); cell++) {
    if (w.cells.first[cell] >= p.owned) continue;  // a ghost cell
    findReachable(w.grid, w.walls, w.cells.key[cell], contacts.reachable);
    if (contacts.reachable.empty()) {
      for (std::size_t i = w.cells.first[cell]; freezing && i < w.cells.first[cell] + w.cells.count[cell];
           i++)
        updateContactOffset(p, w.scene, i, never);
      continue;
    }
    for (std::size_t i = w.cells.first[cell]; i < w.cells.first[cell] + w.cells.count[cell]; i++) {
      const std::size_t before = contacts.list.size();
      // A projected particle may have moved away from, or into, other walls.
      if (listContacts(x, i, contacts, !(p.clamped.active && p.clamped[i]) && !isRigid(p, i))) {
        contacts.list.resize(before);
        listContacts(x, i, contacts, false);
      }
      double nearest = never;
      for (std::size_t c = before; c < contacts.list.size(); c++)
        nearest = std::min(nearest, contacts.list[c].distance);
      if (freezing) updateContactOffset(p, w.scene, i, nearest);
      if (contacts.list.size() > before + 1) distributeShares(x, std::span(contacts.list).subspan(before));
    }
  }
}

void recordProjections(const WallContext& x, const WallContacts& contacts) {
  Continuum& p = x.world.particles;
  for (const Projection& c : contacts.projections) {
    const Vec3d force = p.force[c.row] + x.world.scene.domain.gravity * p.mass[c.row];
    p.dissipated[c.row] += dot(force, c.moved + c.stopped * (0.5 * x.dt));
  }
}

void findSubstepContacts(const WallView& w, std::vector<WallContact>& contacts) {
  const Continuum& p = w.particles;
  contacts.clear();
  const double h = w.grid.support;
  for (const std::uint32_t i : std::span(w.solids.particle.data(), w.solids.owned))
    for (std::uint32_t k = 0; takesSubsteps(p, i) && k < w.walls.list.size(); k++) {
      const Wall& wall = w.walls.list[k];
      const Vec3d rest = restPlace(wall, p.position[i]);
      if (wall.present && nearBounds(wall.bounds, rest, h) && wall.shape->distance(rest) < h)
        contacts.push_back({i, k, 0, {}});
    }
}

bool followContact(const Continuum& p, const Scene& scene, const Walls& walls, WallContact& c) {
  const Wall& wall = walls.list[c.wall];
  const Vec3d rest = restPlace(wall, p.position[c.row]);
  const double reach = 0.5 * scene.spacing;  // contact distance of solids
  if (!wall.present || !nearBounds(wall.bounds, rest, reach)) return false;
  c.distance = wall.shape->distance(rest, &c.normal);
  c.normal = directionFromRest(wall.pose, c.normal);
  return c.distance < reach;
}

double pressureShare(const WallSupport& x, std::span<const WallContact> contacts, std::size_t contact) {
  double share = 1;
  for (std::size_t k = 0; k < contacts.size(); k++)
    if (k != contact) share *= shareBeside(x, contacts[contact], contacts[k]);
  return share;
}

double wallRelativeDensity(const WallSupport& x, std::span<const WallContact> contacts,
                           std::vector<double>& added) {
  // Each wall adds the part of its contribution that does not overlap with earlier walls. Earlier parts are
  // disjoint, so their overlaps add up.
  double relativeDensity = 0;
  for (std::size_t k = 0; k < contacts.size(); k++) {
    const WallIntegrals t = x.tables(contacts[k].distance / x.support);
    const double own = t.space;
    double left = own;
    for (std::size_t other = 0; other < k && left > 0; other++) {
      const double b = x.tables(contacts[other].distance / x.support).space,
                   g = alignment(contacts[k].normal, contacts[other].normal);
      if (b <= 0) continue;
      const double overlap = g <= 0 ? (1 + g) * own * b : (1 - g) * own * b + g * std::min(own, b);
      left -= overlap * (added[other] / b);
    }
    if (added.size() <= k) added.push_back(0);
    added[k] = std::max(left, 0.0);
    if (own > 0) relativeDensity += added[k] / own * t.relativeDensity;
  }
  return relativeDensity;
}

void addWallRelativeDensity(const WallContext& x, double inverseLatticeSum, WallContacts& contacts) {
  Continuum& p = x.world.particles;
  const auto& list = contacts.list;
  for (std::size_t begin = 0, end; begin < list.size(); begin = end) {
    for (end = begin; end < list.size() && list[end].row == list[begin].row;) end++;
    const std::uint32_t i = list[begin].row;
    const double own = wallRelativeDensity({x.tables, x.world.grid.support},
                                           std::span(list).subspan(begin, end - begin), contacts.added);
    p.relativeDensity[i] = static_cast<float>(static_cast<double>(p.relativeDensity[i]) +
                                              inverseLatticeSum * own);
  }
}

}  // namespace thaw
