// SPDX-License-Identifier: Apache-2.0
// Moving surfaces against exact motions and balances: a spinning solid, a melting ball, drops that merge and
// split.
#include <algorithm>
#include <cmath>

#include "benchmarks/accuracy/surface/surface_trials.hpp"

namespace thaw::accuracy {
namespace {

// ---- spin -------------------------------------------------------------------------------------------------
Vec3d centreOfMass(Trial& r) {
  const double mass = sum(r, [](const World& w, std::size_t i) { return w.particles.mass[i]; });
  Vec3d c;
  for (int a = 0; a < 3; a++)
    c[a] = sum(r, [a](const World& w,
                      std::size_t i) { return w.particles.mass[i] * w.particles.position[i][a]; }) /
           mass;
  return c;
}

/// Position of a point of a rigid body that turns about its falling centre of mass.
struct RigidMotion {
  Vec3d axis, from, to;  // unit; m
  double angle;          // rad
  RigidMotion(const World& w, const Vec3d& centre, double t) : from(centre) {
    const Vec3d spin = w.scene.bodies[0].spin;
    axis = normalized(spin);
    angle = length(spin) * t;
    to = centre + w.scene.bodies[0].velocity * t + w.scene.domain.gravity * (0.5 * t * t);
  }
  Vec3d turned(const Vec3d& d) const {
    return std::cos(angle) * d + std::sin(angle) * cross(axis, d) +
           (1 - std::cos(angle)) * dot(axis, d) * axis;
  }
  Vec3d operator()(const Vec3d& x) const { return to + turned(x - from); }
};

/// Records the initial surfels and particles, for comparison with the final ones.
void watchSpin(Trial& r) {
  if (r.world.clock.step > 0) return;
  const SurfelCloud cloud = cloudOf(r);
  const Vec3d c = centreOfMass(r);
  r.series.push_back({0, {c.x, c.y, c.z}});
  for (const CloudSurfel& f : cloud.surfels)
    r.series.push_back({0, {f.position.x, f.position.y, f.position.z, f.normal.x, f.normal.y, f.normal.z}});
  for (const CloudSurfel& f : cloud.surfels) r.ids.push_back(f.id);
}

std::vector<Figure> measureSpin(Trial& r) {
  const SurfelCloud cloud = cloudOf(r);
  const World& w = r.world;
  const auto vec = [&](std::size_t k, std::size_t at) {
    return Vec3d{r.series[k].value[at], r.series[k].value[at + 1], r.series[k].value[at + 2]};
  };
  const RigidMotion exact(w, vec(0, 0), w.clock.time);
  double worst = 0, mean = 0, normals = 0, kept = 0, lag = 0, arms = 0;
  for (const CloudSurfel& f : cloud.surfels) {
    const auto at = std::lower_bound(r.ids.begin(), r.ids.end(), f.id);
    if (at == r.ids.end() || *at != f.id) continue;
    const std::size_t k = 1 + static_cast<std::size_t>(at - r.ids.begin());
    const Vec3d d = f.position - exact(vec(k, 0));
    worst = std::max(worst, length(d));
    mean += length(d);
    const Vec3d arm = cross(exact.axis, exact(vec(k, 0)) - exact.to);
    lag += dot(arm, d);
    arms += dot(arm, arm);
    normals = std::max(normals, degreesBetween(f.normal, exact.turned(vec(k, 3))));
    kept++;
  }
  const double before = static_cast<double>(r.ids.size()), after = static_cast<double>(cloud.surfels.size()),
               unit = w.surface.spacing;
  const Vec3d c = centreOfMass(r) - exact.to;
  std::vector<Figure> all{{"drift/spacing of surfels", worst / unit, 1e-3},
                          {"surfels lost or born", before - kept + after - kept, 0},
                          {"mean drift/spacing of surfels", mean / std::max(1.0, kept) / unit},
                          {"turn ahead (rad)", std::abs(lag / std::max(arms, 1e-300))},
                          {"normals max (deg)", normals},
                          {"drift of the centre/spacing of surfels", length(c) / unit},
                          {"turns", exact.angle / 6.283185307179586},
                          {"updates", static_cast<double>(w.surface.counters.updates)}};
  addCost(r, cloud, all);
  return all;
}

// ---- volumes and events over time -------------------------------------------------------------------------
/// Records the volume enclosed by the surface over that of the particles, after each update.
void watchVolume(Trial& r) {
  const World& w = r.world;
  const auto updates = static_cast<double>(w.surface.counters.updates);
  if (w.clock.step > 0 && r.notes["updates"] == updates) return;
  r.notes["updates"] = updates;
  r.series.push_back(
      {w.clock.time,
       {surfaceVolume(w) / particleVolume(w), static_cast<double>(w.surface.components.size())}});
}

/// Largest deviation of the volume from the initial one.
double volumeError(const Trial& r, double from) {
  double most = 0;
  for (const Sample& s : r.series)
    if (s.time >= from) most = std::max(most, std::abs(s.value[0] / r.series.front().value[0] - 1));
  return most;
}

/// Compares with the initial mesh: the ratio of its volume to that of the particles must be kept.
std::vector<Figure> measureMelt(Trial& r) {
  const SurfelCloud cloud = cloudOf(r);
  const World& w = r.world;
  const double bar = w.scene.surface.enforceVolume > 0 ? 0.01 : never,
               n = sum(r, [](const World&, std::size_t) { return 1.0; });
  const double liquid = sum(r, [](const World& x,
                                  std::size_t i) { return static_cast<double>(x.particles.liquid[i]); }) /
                        n;
  const double top = largest(r, [](const World& x, std::size_t i) { return x.particles.position[i].z; });
  std::vector<Figure> all{
      {"volume at the end", std::abs(r.series.back().value[0] / r.series.front().value[0] - 1), bar},
      {"volume at any time", volumeError(r, 0), bar},
      {"volume/particles' at the start", r.series.front().value[0]},
      {"volume/particles' at the end", r.series.back().value[0]},
      {"components at the end", static_cast<double>(w.surface.components.size())},
      {"splits and merges", static_cast<double>(w.surface.counters.splits + w.surface.counters.merges)},
      {"liquid share at the end", liquid},
      {"height at the end/start", top / 0.11},
      {"updates", static_cast<double>(w.surface.counters.updates)}};
  addCost(r, cloud, all);
  return all;
}

/// Time of the first event of a kind, or the end of the run.
double firstEvent(const World& w, SurfaceEventKind kind) {
  for (const SurfaceEvent& e : w.surface.events)
    if (e.kind == kind) return e.time;
  return w.clock.end;
}

double countEvents(const World& w, SurfaceEventKind kind) {
  double n = 0;
  for (const SurfaceEvent& e : w.surface.events) n += e.kind == kind;
  return n;
}

/// Mean ratio of volumes between two times.
double meanVolume(const Trial& r, double from, double to) {
  double all = 0, n = 0;
  for (const Sample& s : r.series)
    if (s.time >= from && s.time < to) all += s.value[0], n++;
  return n > 0 ? all / n : 0;
}

/// Records volumes and the time of contact. The liquids touch when their distance along x is at most that of
/// particles within each.
void watchMerge(Trial& r) {
  watchVolume(r);
  if (r.notes.contains("touch")) return;
  const double left = largest(r, [](const World& w, std::size_t i) {
    return w.particles.body[i] == 0 ? w.particles.position[i].x : -never;
  });
  const double right = -largest(r, [](const World& w, std::size_t i) {
    return w.particles.body[i] == 1 ? -w.particles.position[i].x : -never;
  });
  if (right - left <= r.spacing()) r.notes["touch"] = r.world.clock.time;
}

std::vector<Figure> measureMerge(Trial& r) {
  const SurfelCloud cloud = cloudOf(r);
  const World& w = r.world;
  const double at = firstEvent(w, SurfaceEventKind::Merge), before = meanVolume(r, 0, at),
               after = meanVolume(r, at, never);
  std::vector<Figure> all{
      {"volume after/before", std::abs(after / before - 1), 0.02},
      {"merges - 1", std::abs(countEvents(w, SurfaceEventKind::Merge) - 1), 0},
      {"splits", countEvents(w, SurfaceEventKind::Split), 0},
      {"merge at (s)", at},
      {"liquids touch at (s)", r.notes.contains("touch") ? r.notes["touch"] : w.clock.end},
      {"volume/particles' before", before},
      {"volume/particles' after", after},
      {"components at the end", static_cast<double>(w.surface.components.size())}};
  addCost(r, cloud, all);
  return all;
}

/// Velocities along x: the ends move apart at `speed` (m/s), and the neck within 1 m of the middle stretches.
std::function<void(Trial&)> pulledAt(double speed) {
  return [speed](Trial& r) {
    Continuum& p = r.world.particles;
    for (std::size_t i = 0; i < p.owned; i++)
      p.velocity[i] = {speed * std::clamp(p.position[i].x, -1.0, 1.0), 0, 0};
  };
}

std::vector<Figure> measureSplit(Trial& r) {
  const SurfelCloud cloud = cloudOf(r);
  const World& w = r.world;
  const double at = firstEvent(w, SurfaceEventKind::Split), before = meanVolume(r, 0, at),
               after = meanVolume(r, at, never);
  double large = 0, second = 0, total = 0;  // m^3, volumes of components
  for (const SurfaceComponent& c : w.surface.components) {
    total += c.particleVolume;
    if (c.particleVolume > large) second = large, large = c.particleVolume;
    else second = std::max(second, c.particleVolume);
  }
  std::vector<Figure> all{{"volume after/before", std::abs(after / before - 1), 0.02},
                          {"difference of halves", std::abs(large - second) / total, 0.02},
                          {"not parted", countEvents(w, SurfaceEventKind::Split) == 0 ? 1.0 : 0.0, 0},
                          {"split at (s)", at},
                          {"splits", countEvents(w, SurfaceEventKind::Split)},
                          {"merges", countEvents(w, SurfaceEventKind::Merge)},
                          {"volume/particles' before", before},
                          {"volume/particles' after", after},
                          {"components at the end", static_cast<double>(w.surface.components.size())}};
  addCost(r, cloud, all);
  return all;
}

/// Farthest end of the liquid along x (m): the outermost particle plus half a spacing.
double tip(Trial& r) {
  return largest(r, [](const World& w, std::size_t i) { return w.particles.position[i].x; }) +
         r.spacing() / 2;
}

void watchHeld(Trial& r) {
  watchVolume(r);
  if (r.world.clock.step == 0) r.notes["start"] = tip(r);
  r.notes["farthest"] = std::max(r.notes["farthest"], tip(r));
}

/// The kinetic energy of the pull is 0.39 J. Two balls have 0.66 J more surface energy than the initial drop,
/// so it may not split.
std::vector<Figure> measureHeld(Trial& r) {
  const SurfelCloud cloud = cloudOf(r);
  const World& w = r.world;
  std::vector<Figure> all{{"splits", countEvents(w, SurfaceEventKind::Split), 0},
                          {"components - 1", static_cast<double>(w.surface.components.size()) - 1, 0},
                          {"end/start of its length", tip(r) / r.notes["start"], 1},
                          {"volume at any time", volumeError(r, 0), 0.02},
                          {"farthest end (m)", r.notes["farthest"]}};
  addCost(r, cloud, all);
  return all;
}

}  // namespace

std::vector<Case> movingSurfaceCases() {
  return {
      {"surface_spin",
       "surfels of a solid that falls and spins by one turn; rigid motion",
       nullptr,
       {},
       {},
       watchSpin,
       measureSpin},
      {"surface_melt",
       "a solid ball with a mesh melts to a puddle; volume enclosed by the surface over that of the "
       "particles",
       nullptr,
       {},
       {},
       watchVolume,
       measureMelt},
      {"surface_merge",
       "two drops merge; time of contact (0.25 s for rigid balls) and volumes",
       nullptr,
       {},
       {},
       watchMerge,
       measureMerge},
      {"surface_split",
       "a drop is pulled apart; time, halves and volumes",
       nullptr,
       {},
       pulledAt(2),
       watchVolume,
       measureSplit},
      {"surface_held",
       "a long drop is pulled with less energy than a split needs; it contracts",
       nullptr,
       {},
       pulledAt(0.25),
       watchHeld,
       measureHeld},
  };
}

}  // namespace thaw::accuracy
