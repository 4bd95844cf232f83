// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/forces/oriented_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/halo/exchange.hpp"
#include "core/math/hash_random.hpp"
#include "core/oriented/forces/fields.hpp"
#include "core/oriented/laws/crease_pair.hpp"
#include "core/oriented/laws/oriented_reach.hpp"
#include "core/time/frame_times.hpp"

namespace thaw {
namespace {

constexpr double reachOfContact = 0.9;  // spacings, distance at which particles of different surfaces touch

struct WallReaction {
  Vec3d force{}, velocity{};
  double energy = 0, loss = 0, stiffness = 0, slope = 0;
};

/// Returns the contact of one obstacle with row i: a spring and a barrier within `thickness` spacings, and
/// friction (Coulomb, viscous at low slip speed).
WallReaction wallReaction(const OrientedView& w, const Wall& wall, std::size_t i) {
  const Oriented& o = w.oriented.rows;
  const OrientedBody& body = w.scene.oriented[o.body[i]];
  const PairPotential& p = w.work.potentials[o.body[i]];
  WallReaction push;
  if (!wall.present) return push;
  const ObstacleContact& contact = w.work.obstacles[o.body[i]];
  const double keep = contact.keep, deepest = 4 * p.spacing;
  const Vec3d rest = toRest(wall.pose, o.position[i]);
  if (!nearBounds(wall.bounds, rest, keep)) return push;
  Vec3d n;
  const double d = wall.shape->distanceWithin(rest, std::max(keep, deepest), &n),
               depth = std::min(keep - d, deepest);
  if (!(depth > 0)) return push;
  n = directionFromRest(wall.pose, n);
  const ObstacleForce at = obstacleForceAt(contact, depth);
  const double k = contact.spring, normalForce = at.force;
  push.velocity = wallVelocity(wall, o.position[i]);
  push.energy = at.energy;
  const Vec3d slip = o.velocity[i] - push.velocity, along = slip - dot(slip, n) * n;
  // slope at the end of the next step
  push.slope = obstacleForceAt(contact, std::min(contact.room * (1 - 1e-9),
                                                 depth + std::clamp(-1.1 * nextStep(w.clock) * dot(slip, n),
                                                                    0.0, 0.1 * p.spacing)))
                   .slope;
  push.stiffness = k + push.slope;
  const double speed = length(along), drag = 0.5 * std::sqrt(k * o.mass[i]),
               friction = std::max(body.friction, wall.properties.friction);
  const double tangential = std::min(friction * normalForce, drag * speed);
  push.force = normalForce * n;
  if (speed > 0) push.force -= (tangential / speed) * along;
  push.loss = tangential * speed;
  return push;
}

/// Returns a small torque along a random direction, the same for both particles. Without it, antiparallel
/// normals have no torque (docs/validation/stability.md, row 17).
Vec3d antiparallelTorque(const Scene& scene, const PairPotential& p, std::uint64_t a, std::uint64_t b,
                         const Vec3d& n) {
  const double angle = 2 * std::numbers::pi *
                       randomUniform(scene.seed, Purpose::OrientedKick, std::min(a, b), std::max(a, b));
  const Vec3d e = std::abs(n.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, u = normalized(cross(n, e)),
              v = cross(n, u);
  return ((a < b ? 1e-3 : -1e-3) * p.scale) * (std::cos(angle) * u + std::sin(angle) * v);
}

}  // namespace

void findNormals(Oriented& o) {
  for (std::size_t i = 0; i < o.owned; i++) o.normal[i] = axisOf(o.orientation[i]);
}

void updateNeighbours(OrientedBodies& b, const Scene& scene, Halos halos, OrientedLists& l) {
  Oriented& o = b.rows;
  findNormals(o);
  sendGhosts(*halos.bodyTypes[orientedType], o, b.cells,
             ColumnList{&o.id, &o.position, &o.velocity, &o.normal, &o.group, &o.cutSides, &o.flags, &o.body})
      .wait();

  l.first.clear();
  l.list.clear();
  const double reach = orientedReach(scene), reach2 = reach * reach;
  const CellTable& cells = b.cells;
  for (std::size_t c = 0; c < cells.key.size(); c++) {
    if (cells.first[c] >= o.owned) continue;
    std::size_t around[27];
    int found = 0;
    const Vec3i at = cellOfKey(cells.key[c]);
    for (int z = -1; z <= 1; z++)
      for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++) {
          const std::uint64_t key = cellKey({at.x + x, at.y + y, at.z + z});
          const auto it = std::lower_bound(cells.key.begin(), cells.key.end(), key);
          if (it != cells.key.end() && *it == key)
            around[found++] = static_cast<std::size_t>(it - cells.key.begin());
        }
    for (std::uint32_t i = cells.first[c]; i < cells.first[c] + cells.count[c]; i++) {
      l.first.push_back(static_cast<std::uint32_t>(l.list.size()));
      for (int k = 0; k < found; k++)
        for (std::uint32_t j = cells.first[around[k]]; j < cells.first[around[k]] + cells.count[around[k]];
             j++) {
          const Vec3d r = o.position[j] - o.position[i];
          if (j != i && dot(r, r) < reach2) l.list.push_back(j);
        }
    }
  }
  l.first.push_back(static_cast<std::uint32_t>(l.list.size()));
}

void refreshGhostPoses(Oriented& o, Halos halos) {
  refresh(*halos.bodyTypes[orientedType], o, ColumnList{&o.position, &o.normal}).wait();
}

void sumOrientedForces(const OrientedView& w) {
  Oriented& o = w.oriented.rows;
  const OrientedLists& l = w.work.lists;
  w.work.obstacleFrequency2 = 0;
  for (std::size_t i = 0; i < o.owned; i++) {
    const OrientedBody& body = w.scene.oriented[o.body[i]];
    const Vec3d x = o.position[i], n = o.normal[i];
    const FieldForce field = fieldForce(w, i);
    Vec3d force = (o.external.active ? o.external[i] : Vec3d{}) + field.force, torque{};
    double energy = 0, stiff = 0, turn = 0;
    for (std::uint32_t k = l.first[i]; k < l.first[i + 1]; k++) {
      const std::uint32_t j = l.list[k];
      const PairPotential& p = potentialOf(w.work, o, i, j);
      const Vec3d r = o.position[j] - x;
      const bool folded = ((o.flags[i] | o.flags[j]) & creased) != 0;
      const bool same = sameSurface(o, i, j), opposite = p.facing && !folded && !(dot(n, o.normal[j]) > 0);
      if (same && !opposite) {
        const PairResult f = folded ? creasedPair(p, r, n, o.normal[j], o.flags[i] & creased,
                                                  o.flags[j] & creased)
                                    : pairForces(p, r, n, o.normal[j]);
        force += f.force;
        torque += f.torque;
        energy += 0.5 * f.energy;
        stiff += f.stiffness;
        turn += f.turnStiffness;
        if (!p.facing && dot(n, o.normal[j]) < -1 + 1e-9)
          torque += antiparallelTorque(w.scene, p, o.id[i], o.id[j], n);
      } else if (const double r2 = dot(r, r), d = reachOfContact * p.spacing; r2 < d * d && r2 > 0) {
        const double far = std::sqrt(r2), stiffness = body.contact * body.stiffness,
                     share = w.scene.oriented[o.body[j]].contact * w.scene.oriented[o.body[j]].stiffness;
        const double between = 0.5 * (stiffness + share);
        force -= (between * (d - far) / far) * r;
        energy += 0.25 * between * (d - far) * (d - far);
        stiff += between;
      }
    }
    for (const Wall& wall : w.walls.list) {
      const WallReaction push = wallReaction(w, wall, i);
      force += push.force;
      energy += push.energy;
      stiff += push.stiffness;
      if (push.slope > 0)
        w.work.obstacleFrequency2 = std::max(w.work.obstacleFrequency2, push.slope / o.mass[i]);
    }
    if (body.planar) {
      force.y = 0;
      torque.x = torque.z = 0;
    }
    o.force[i] = force;
    o.torque[i] = torque;
    o.energy[i] = energy;
    o.stiffness[i] = 2 * stiff / o.mass[i] + 2 * turn / o.inertia[i] + field.slope;
  }
}

void recordObstacleWork(const OrientedView& w, double dt) {
  Oriented& o = w.oriented.rows;
  for (std::size_t i = 0; i < o.owned; i++) {
    const Vec3d field = fieldForce(w, i).force;
    const bool recorded = w.scene.oriented.front().integrator != OrientedIntegrator::RungeKutta &&
                          !(o.flags[i] & fixedPosition);
    Vec3d impulse = field * dt;
    double work = recorded ? 0 : dot(field, o.velocity[i]) * dt;
    for (const Wall& wall : w.walls.list) {
      const WallReaction push = wallReaction(w, wall, i);
      impulse += push.force * dt;
      work += dot(push.force, push.velocity) * dt;
      o.dissipated[i] += push.loss * dt;
    }
    for (int a = 0; a < 3; a++)
      if (impulse[a] != 0) w.ledger.wallImpulse[a].add(impulse[a]);
    if (work != 0) w.ledger.wallWork.add(work);
  }
}

}  // namespace thaw
