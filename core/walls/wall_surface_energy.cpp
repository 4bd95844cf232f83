// SPDX-License-Identifier: Apache-2.0
#include "core/walls/wall_surface_energy.hpp"

#include <algorithm>

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/materials/rest_density.hpp"
#include "core/materials/surface_tension.hpp"
#include "core/scene/tension_form.hpp"

namespace thaw {
namespace {

WallColour atWall(const Scene& scene, const CellGrid& grid, const WallContact& c) {
  const double h = grid.support, dx = scene.spacing / h;
  return wallColour(dx, std::max(c.distance / h, -0.5 * dx));
}

/// Sums of a particle without its walls of one contact angle.
SurfaceKernelValue sumsWithout(const SurfaceContext& x, const SurfaceParticle& p, double wetting) {
  SurfaceKernelValue sums = p.sums;
  for (const WallContact& c : p.contacts) {
    if (wettingAt(x.world, c) != wetting) continue;
    const WallColour t = atWall(x.world.scene, x.world.grid, c);
    sums.gradient -= c.normal * (t.slope * c.share);
    sums.colour -= t.colour * c.share;
  }
  return sums;
}

/// Calls action(wetting, state) for each contact angle of a particle, with the state without the walls of
/// this angle.
template<class Action> void eachAngle(const SurfaceContext& x, const SurfaceParticle& p, Action&& action) {
  for (std::size_t k = 0; k < p.contacts.size(); k++) {
    const double wetting = wettingAt(x.world, p.contacts[k]);
    bool skip = wetting == 0;
    for (std::size_t before = 0; before < k && !skip; before++)
      skip = wettingAt(x.world, p.contacts[before]) == wetting;
    if (skip) continue;
    const SurfaceKernelValue sums = sumsWithout(x, p, wetting);
    action(wetting, surfaceState(x.measure, p.tension, sums.gradient, sums.colour));
  }
}

void add(SurfaceState& to, double weight, const SurfaceState& state) {
  to.energy += weight * state.energy;
  to.byGradient += state.byGradient * weight;
  to.byColour += weight * state.byColour;
}

/// State of a particle with walls of all angles.
SurfaceState stateOf(const SurfaceContext& x, const SurfaceParticle& p) {
  const SurfaceState with = surfaceState(x.measure, p.tension, p.sums.gradient, p.sums.colour);
  SurfaceState all = with;
  eachAngle(x, p, [&](double wetting, const SurfaceState& without) {
    add(all, -wetting, without);
    add(all, wetting, with);
  });
  return all;
}

/// Force (N) of a wall along its normal, from the particle's state.
double forceAlong(const SurfaceContext& x, const WallContact& c, const SurfaceState& state) {
  const WallView& w = x.world;
  const WallColour t = atWall(w.scene, w.grid, c);
  const double V = restVolumeOf(w.particles, w.scene.materials, c.row);
  return -V * c.share / w.grid.support *
         (dot(state.byGradient, c.normal) * t.bend + state.byColour * t.slope);
}

/// Adds the forces of a particle's walls. The state without the walls of one angle does not depend on the
/// distance from these walls.
void addForces(const SurfaceContext& x, const SurfaceParticle& p, const SurfaceState& all, double dt) {
  const WallView& w = x.world;
  const auto addAt = [&](double wetting, const SurfaceState& state) {
    for (const WallContact& c : p.contacts) {
      if (wettingAt(w, c) != wetting) continue;
      const Wall& wall = w.walls.list[c.wall];
      const Vec3d force = c.normal * forceAlong(x, c, state);
      w.particles.force[p.row] += force;
      for (int a = 0; a < 3; a++) w.ledger.wallForce[a].add(force[a]);
      if (!wall.properties.motion.empty())
        w.ledger.wallWork.add(dot(force, wallVelocity(wall, w.particles.position[p.row])) * dt);
    }
  };
  addAt(0, all);
  eachAngle(x, p, [&](double wetting, const SurfaceState& without) {
    SurfaceState moving = all;
    add(moving, wetting, without);
    addAt(wetting, moving);
  });
}

}  // namespace

double wettingOf(const Material& m, const Obstacle& wall) {
  return wettingOf(wall.contactAngle < never ? wall.contactAngle : m.contactAngle);
}

double wettingAt(const WallView& w, const WallContact& c) {
  return wettingOf(w.scene.materials[w.particles.material[c.row]], w.walls.list[c.wall].properties);
}

void updateSurfaceTension(const WallView& w) {
  Continuum& p = w.particles;
  for (std::size_t i = 0; i < p.owned; i++)
    p.surfaceTension[i] = static_cast<float>(
        surfaceTensionAt(w.scene.materials[p.material[i]], p.temperature[i]));
}

double tensionOfParticle(const WallView& w, std::size_t i) {
  if (w.modules.tensionTable) return static_cast<double>(w.particles.surfaceTension[i]);
  return w.scene.materials[w.particles.material[i]].surfaceTension;
}

double surfaceEnergyOf(const SurfaceContext& x, const SurfaceParticle& p) { return stateOf(x, p).energy; }

double surfaceEnergyWith(const SurfaceContext& x, std::uint32_t i, std::span<const WallContact> contacts) {
  const WallView& w = x.world;
  const Continuum& p = w.particles;
  const double tension = liquidFraction(p, i) * tensionOfParticle(w, i);
  if (!(tension > 0)) return 0;
  SurfaceKernelValue sums{p.surfaceGradient[i], p.surfaceColour[i]};
  for (const WallContact& c : contacts) {
    const WallColour t = atWall(w.scene, w.grid, c);
    sums.gradient += c.normal * (t.slope * c.share);
    sums.colour += t.colour * c.share;
  }
  const auto angles = w.modules.contactAngle ? contacts : std::span<const WallContact>();
  return surfaceEnergyOf(x, {i, tension, sums, angles}) * p.mass[i] / restDensityOf(p, w.scene.materials, i);
}

void findSurfaceEnergy(const WallContext& walls, const SurfaceMeasure& measure,
                       const WallContacts& contacts) {
  const WallView& w = walls.world;
  const SurfaceContext x{w, measure};
  Continuum& p = w.particles;
  const bool angles = w.modules.contactAngle;
  for (const WallContact& c : contacts.list) {
    const WallColour t = atWall(w.scene, w.grid, c);
    p.surfaceGradient[c.row] += c.normal * (t.slope * c.share);
    p.surfaceColour[c.row] += t.colour * c.share;
  }
  if (w.modules.tensionTable) updateSurfaceTension(w);
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < p.owned; i++) {
    const std::size_t begin = next;
    while (angles && next < contacts.list.size() && contacts.list[next].row == i) next++;
    const double tension = liquidFraction(p, i) * tensionOfParticle(w, i);
    p.surfaceEnergyByGradient[i] = {};
    p.surfaceEnergyByColour[i] = 0;
    if (!(tension > 0)) continue;
    const SurfaceParticle particle{i,
                                   tension,
                                   {p.surfaceGradient[i], p.surfaceColour[i]},
                                   std::span<const WallContact>(contacts.list).subspan(begin, next - begin)};
    const SurfaceState s = stateOf(x, particle);
    if (next > begin && !isRigid(p, i)) addForces(x, particle, s, walls.dt);
    p.surfaceEnergyByGradient[i] = s.byGradient;
    p.surfaceEnergyByColour[i] = s.byColour;
    p.interaction[i] += s.energy * p.mass[i] / restDensityOf(p, w.scene.materials, i);
  }
}

double surfaceForceOfWall(const Scene& scene, const CellGrid& grid, const Continuum& p,
                          const WallContact& c) {
  const WallColour t = atWall(scene, grid, c);
  const double V = restVolumeOf(p, scene.materials, c.row);
  return -V * c.share / grid.support *
         (dot(p.surfaceEnergyByGradient[c.row], c.normal) * t.bend +
          p.surfaceEnergyByColour[c.row] * t.slope);
}

void recordTensionChange(const SurfaceContext& x, const WallContacts& contacts) {
  const WallView& w = x.world;
  const Continuum& p = w.particles;
  for (std::uint32_t i = 0; i < p.owned; i++) {
    const Material& m = w.scene.materials[p.material[i]];
    const double f = liquidFraction(p, i), before = tensionOfParticle(w, i),
                 after = static_cast<double>(static_cast<float>(surfaceTensionAt(m, p.temperature[i])));
    if (after == before || !(f > 0 && before > 0)) continue;
    // A particle that was not liquid at the evaluation had no surface energy, and its sums may be missing.
    if (p.surfaceEnergyByColour[i] == 0 &&
        dot(p.surfaceEnergyByGradient[i], p.surfaceEnergyByGradient[i]) == 0)
      continue;
    const auto near = w.modules.contactAngle ? contactsOf(contacts, i) : std::span<const WallContact>();
    const double energy = surfaceEnergyOf(
        x, {i, after - before, {p.surfaceGradient[i], p.surfaceColour[i]}, near});
    w.ledger.phaseJump.add(-f * energy * p.mass[i] / restDensityOf(p, w.scene.materials, i));
  }
}

}  // namespace thaw
