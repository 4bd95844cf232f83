#include "core/fluid/incompressible/pressure_solver.hpp"

#include <algorithm>
#include <cmath>

#include "core/fluid/incompressible/pressure_system.hpp"

namespace thaw {
namespace {

/// What a solve is to reach: no predicted compression e = (filling - full) + dt d(filling)/dt. Of a
/// compression that is there a share only is undone in a step: all of it at once throws the surface of a deep
/// liquid off, with error * depth / dt. The tolerance is of the same share.
struct Goal {
  double dt;         ///< s
  double tolerance;  ///< 1, mean of what is left
  double share;      ///< 1, of a compression that is there; divergence: 0
};

/// Exact over ranks, as integers: how much is left, of how many, and whether the last move went uphill.
struct Progress {
  std::int64_t left = 0, liquids = 0, along = 0;
  static constexpr double leftUnit = 1.0 / (1 << 30), alongUnit = 1.0 / (1ll << 50);
  void add(double residual, double work) {
    left += std::llround(std::min(residual, 100.0) / leftUnit);
    along += std::llround(std::clamp(work, -1e-3, 1e-3) / alongUnit);
    liquids++;
  }
  void reduce(Reducer& all) {
    std::int64_t v[] = {left, liquids, along};
    all.sum(v);
    left = v[0], liquids = v[1], along = v[2];
  }
  double mean() const {
    return liquids > 0 ? static_cast<double>(left) * leftUnit / static_cast<double>(liquids) : 0;
  }
};

/// A Jacobi step of every pressure, cut at 0, into `stepped`; what is left before it, and whether it goes
/// along with the step before.
Progress jacobiStep(const PressureSystem& x, const Goal& goal, std::vector<float>& stepped) {
  const Continuum& p = x.world.particles;
  const PressureWork& work = x.tools.pressure;
  const bool mayPull = x.world.scene.numerics.tensileLimit > 0;
  Progress progress;
  for (std::size_t i = 0; i < p.owned; i++) {
    stepped[i] = 0;
    if (!(work.response[i] > 0)) continue;
    const double f = static_cast<double>(work.fraction[i]), full = goal.dt * work.response[i],
                 k = static_cast<double>(p.trialPressure[i]);
    double filled = static_cast<double>(p.filling[i]) - work.full;
    if (mayPull)
      filled = std::max(filled, 0.0);  // what pulls keeps gaps from growing; to close those of a free surface
                                       // would tear it apart
    // half-molten: as a spring beside the constraint, so soft that a lone particle's pressure is the liquid
    // fraction of a liquid's
    const double e = (filled > 0 ? goal.share * filled : filled) + goal.dt * work.rate[i] -
                     (1 - f) * full * k;
    const double left = mayPull || k * full > -e ? std::abs(e) : k * full;
    double next = k + x.tools.pressure.relaxation * e / full;
    if (!mayPull) next = std::max(next, 0.0);
    stepped[i] = static_cast<float>(next);
    progress.add(left, e * (next - static_cast<double>(work.before[i])) * full);
  }
  return progress;
}

/// From trialPressure on: pressures, impulses and trialVelocity. Returns the iterations.
std::int64_t solve(const PressureSystem& x, const Goal& goal) {
  World& w = x.world;
  Continuum& p = w.particles;
  PressureWork& work = x.tools.pressure;
  std::copy_n(p.trialPressure.data(), p.owned, work.before.begin());
  double momentum = 1;
  for (std::int64_t iteration = 1;; iteration++) {
    applyPressures(x);
    rateOfFilling(x);
    Progress progress = jacobiStep(x, goal, work.stepped);
    x.tools.times.lap(StepPhase::Pressure);
    progress.reduce(x.halos.all);
    x.tools.times.lap(StepPhase::Reduce);
    const bool done = progress.mean() <= goal.tolerance;
    if (done || iteration >= w.scene.numerics.maxIterations) {
      if (!done && x.halos.all.rank() == 0) w.counters.unsolvedPressures++;
      return iteration;
    }
    if (progress.along < 0) momentum = 1;
    const double next = 0.5 * (1 + std::sqrt(1 + 4 * momentum * momentum));
    const float ahead = static_cast<float>((momentum - 1) / next);
    momentum = next;
    const bool mayPull = w.scene.numerics.tensileLimit > 0;
    for (std::size_t i = 0; i < p.owned; i++) {
      const float k = work.stepped[i] + ahead * (work.stepped[i] - work.before[i]);
      p.trialPressure[i] = mayPull ? k : std::max(k, 0.0f);
    }
    work.before.swap(work.stepped);
  }
}

/// Impulses and work that walls, and what holds or drives particles, gave in a solve. `book` takes an impulse
/// (N s).
template<class Book> void bookReactions(const PressureSystem& x, Book book) {
  World& w = x.world;
  Continuum& p = w.particles;
  const auto give = [&](std::size_t i, const Vec3d& impulse, const Vec3d& velocity) {
    book(impulse);
    const double done = dot(impulse, velocity);
    if (done == 0) return;
    w.ledger.wallWork.add(done);
    p.dissipated[i] += done;  // the velocities' change takes it away again
  };
  for (const WallSlope& wall : x.tools.pressure.walls) {
    if (p.clamped.active && p.clamped[wall.row]) continue;  // what holds it has to bear this too
    const double V = p.mass[wall.row] / w.scene.materials[p.material[wall.row]].density;
    give(wall.row, wall.slope * (-V * static_cast<double>(p.trialPressure[wall.row])), wall.velocity);
  }
  if (!p.clamped.active) return;
  for (const WallSlope& wall : x.tools.pressure.walls) {  // of the pairs only: a wall's impulse on what is
                                                          // held goes from one holder to the other
    const double V = p.mass[wall.row] / w.scene.materials[p.material[wall.row]].density;
    if (p.clamped[wall.row])
      x.tools.pressure.impulse[wall.row] += wall.slope * (V * static_cast<double>(p.trialPressure[wall.row]));
  }
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.clamped[i]) give(i, -x.tools.pressure.impulse[i], p.clamped[i] == driven ? p.velocity[i] : Vec3d{});
}

/// Liquid that pressure does not hold away from a wall, a lone drop, stops a quarter of a spacing from it.
/// Changes trialVelocity.
template<class Book> void stopAtWalls(const PressureSystem& x, double dt, Book book) {
  World& w = x.world;
  Continuum& p = w.particles;
  for (const WallContact& c : x.tools.wallContacts.list) {
    const double f = static_cast<double>(x.tools.pressure.fraction[c.row]),
                 room = std::max(0.0, c.distance - 0.25 * w.scene.spacing);
    if (f == 0 || (p.clamped.active && p.clamped[c.row])) continue;
    const Vec3d v = wallVelocity(w.walls.list[c.wall], p.position[c.row]);
    const double excess = -dot(p.trialVelocity[c.row] - v, c.normal) - room / dt;
    if (excess <= 0) continue;
    const Vec3d change = c.normal * (f * excess), impulse = change * p.mass[c.row];
    p.trialVelocity[c.row] += change;
    book(impulse);
    const double done = dot(impulse, v);
    w.ledger.wallWork.add(done);
    p.dissipated[c.row] += done;
  }
}

/// From the pressure of the last step. What has frozen since has none: whether pairs of solids are listed
/// depends on who shares their group, and so on the ranks.
void setTrial(Continuum& p, const PressureWork& work, const Column<float>& pressure, double dt) {
  for (std::size_t i = 0; i < p.owned; i++)
    p.trialPressure[i] = work.response[i] > 0 ? static_cast<float>(static_cast<double>(pressure[i]) * dt) : 0;
}

void keepTrial(const Continuum& p, Column<float>& pressure, double dt) {
  for (std::size_t i = 0; i < p.owned; i++)
    pressure[i] = static_cast<float>(static_cast<double>(p.trialPressure[i]) / dt);
}

/// What resists was booked at the velocity of the drift, v. It works in the half kick behind, at v + a dt/4
/// on the mean, and in the one that comes, at v + a dt/2 + change by pressure + a next/4: at steps that are
/// near the viscous limit that is a good part of it.
void bookResistance(World& w, const std::vector<Vec3d>& before, double dt, double next) {
  Continuum& p = w.particles;
  const double both = (dt + next) * (dt + next) / 8, half = 0.5 * next;
  for (std::size_t i = 0; i < p.owned; i++)
    if (!(p.clamped.active && p.clamped[i]))
      p.dissipated[i] -= dot(
          p.drag[i], (p.velocity[i] + p.pressureKick[i] - before[i]) * half + p.acceleration[i] * both);
}

/// Changes velocity by `change`; what the kinetic energy loses is dissipated.
void change(Continuum& p, std::size_t i, const Vec3d& change) {
  p.dissipated[i] -= p.mass[i] * dot(change, p.velocity[i] + change * 0.5);
  p.velocity[i] += change;
}

/// Velocities without compression.
void stopCompression(const PressureSystem& x, double dt, double next, double share) {
  World& w = x.world;
  Continuum& p = w.particles;
  std::copy_n(p.velocity.data(), p.owned, x.tools.pressure.start.begin());
  setTrial(p, x.tools.pressure, p.steadying, dt);
  w.lastIterations.divergence = solve(x, {next, share * w.scene.numerics.divergenceTolerance, 0});
  keepTrial(p, p.steadying, dt);
  bookReactions(x, [&](const Vec3d& impulse) {
    for (int a = 0; a < 3; a++) w.ledger.wallImpulse[a].add(impulse[a]);
  });
  for (std::size_t i = 0; i < p.owned; i++) change(p, i, p.trialVelocity[i] - p.velocity[i]);
}

/// The kick with which the next drift ends at full fillings.
void keepVolume(const PressureSystem& x, double next, double share) {
  World& w = x.world;
  Continuum& p = w.particles;
  PressureWork& work = x.tools.pressure;
  const double half = 0.5 * next;
  for (std::size_t i = 0; i < p.owned; i++) work.start[i] = p.velocity[i] + p.acceleration[i] * half;
  setTrial(p, work, p.holding, next);
  w.lastIterations.density = solve(x, {next, share * w.scene.numerics.densityTolerance, share});
  keepTrial(p, p.holding, next);
  const auto book = [&](const Vec3d& impulse) {  // with the next half kick
    for (int a = 0; a < 3; a++) w.ledger.wallForce[a].add(impulse[a] / half);
  };
  bookReactions(x, book);
  stopAtWalls(x, next, book);
  for (std::size_t i = 0; i < p.owned; i++) p.pressureKick[i] = p.trialVelocity[i] - work.start[i];
}

}  // namespace

void addPressureKick(World& w) {
  Continuum& p = w.particles;
  for (std::size_t i = 0; i < p.owned; i++) change(p, i, p.pressureKick[i]);
}

void findPressure(World& w, Halos halos, StepTools& t, double dt) {
  Continuum& p = w.particles;
  const PressureSystem system{w, halos, t};
  // the scene is over, and nothing limits a step
  const double planned = nextStep(w.clock), next = std::isfinite(planned) ? planned : dt;
  std::vector<Vec3d>& before = t.pressure.arrived;
  before.assign(p.velocity.data(), p.velocity.data() + p.owned);
  const double share = std::min(1.0, next / t.pressure.mendingTime);
  prepareSystem(system);
  stopCompression(system, dt, next, share);
  keepVolume(system, next, share);
  bookResistance(w, before, dt, next);
  if (halos.all.rank() == 0) {
    w.counters.densityIterations += w.lastIterations.density;
    w.counters.divergenceIterations += w.lastIterations.divergence;
  }
  t.times.lap(StepPhase::Pressure);
}

}  // namespace thaw
