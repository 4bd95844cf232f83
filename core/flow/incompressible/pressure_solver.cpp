// SPDX-License-Identifier: Apache-2.0
#include "core/flow/incompressible/pressure_solver.hpp"

#include <algorithm>
#include <cmath>

#include "core/materials/rest_density.hpp"
#include "core/time/frame_times.hpp"

namespace thaw {
namespace {

/// Goal of a solve: zero predicted compression e = (relative density - target) + dt d(relative density)/dt.
/// Only a fraction of an existing compression is corrected per step. A full correction would eject the
/// surface of a deep liquid at error * depth / dt. The tolerance scales with the fraction.
struct Goal {
  double dt;         ///< s
  double tolerance;  ///< 1, mean residual
  double share;      ///< 1, corrected fraction of an existing compression; divergence solve: 0
  double mean = 0;   ///< 1, mean compression of liquid that cannot expand; it is not corrected
};

/// Residual, number of particles, and alignment of the residual with the last move. Sums over ranks are
/// exact, since they are integers.
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

/// Returns the compression (1) that a solve corrects in this step, in addition to the compression by the
/// flow. Inside the liquid both signs are corrected slowly, since shear changes the summed density by a few
/// per cent. Elsewhere the liquid may fill a deficit at once.
double sourceOf(const PressureSystem& x, double share, std::size_t i) {
  const double inside = static_cast<double>(x.pressure.inside[i]);
  double excess = static_cast<double>(x.particles.relativeDensity[i]) - x.pressure.targetRelativeDensity;
  if (x.scene.numerics.tensileLimit > 0)
    excess = std::max(excess, 0.0);  // tension keeps gaps from growing; closing gaps at a free surface would
                                     // tear it apart
  const double room = excess > 0 ? share * excess : excess;
  return inside * share * excess + (1 - inside) * room;
}

/// One Jacobi step of every pressure, clamped at 0, into `stepped`. Returns the residual before the step and
/// its alignment with the previous move.
Progress jacobiStep(const PressureSystem& x, const Goal& goal, std::vector<float>& stepped) {
  const Continuum& p = x.particles;
  const PressureWork& work = x.pressure;
  const bool mayPull = x.scene.numerics.tensileLimit > 0;
  Progress progress;
  for (std::size_t i = 0; i < p.owned; i++) {
    stepped[i] = 0;
    if (!(work.response[i] > 0)) continue;
    const double f = static_cast<double>(work.fraction[i]), full = goal.dt * work.response[i],
                 k = static_cast<double>(p.trialPressure[i]);
    // Half-molten particles also get a spring. Its stiffness is such that a single particle has the
    // pressure of a liquid times its liquid fraction.
    const double e = sourceOf(x, goal.share, i) - goal.share * goal.mean + goal.dt * work.rate[i] -
                     (1 - f) * full * k;
    const double left = mayPull || k * full > -e ? std::abs(e) : k * full;
    double next = k + x.pressure.relaxation * e / full;
    if (!mayPull) next = std::max(next, 0.0);
    stepped[i] = static_cast<float>(next);
    progress.add(left, e * (next - static_cast<double>(work.before[i])) * full);
  }
  return progress;
}

/// Returns the mean of the compressions that the density solve corrects, exact over ranks, in liquid without
/// a free surface. Motion hardly reduces this mean. A solve that tried to reduce it would raise all pressures
/// without limit, and disordered particles under pressure resist shear.
double meanCompression(const PressureSystem& x) {
  if (!x.pressure.closed) return 0;
  const Continuum& p = x.particles;
  Progress sum;
  for (std::size_t i = 0; i < p.owned; i++)
    if (x.pressure.response[i] > 0)
      sum.add(x.pressure.inside[i] > 0 ? sourceOf(x, 1, i) : std::max(sourceOf(x, 1, i), 0.0), 0);
  sum.reduce(x.halos.all);
  return sum.mean();
}

/// Solves for pressures, impulses and trialVelocity from the initial trialPressure. Returns the number of
/// iterations.
std::int64_t solve(const PressureSystem& x, const Goal& goal) {
  Continuum& p = x.particles;
  PressureWork& work = x.pressure;
  std::copy_n(p.trialPressure.data(), p.owned, work.before.begin());
  double momentum = 1;
  for (std::int64_t iteration = 1;; iteration++) {
    applyPressures(x);
    relativeDensityRate(x);
    Progress progress = jacobiStep(x, goal, work.stepped);
    x.times.lap(StepPhase::Pressure);
    progress.reduce(x.halos.all);
    x.times.lap(StepPhase::Reduce);
    const bool done = progress.mean() <= goal.tolerance;
    if (done || iteration >= x.scene.numerics.maxIterations) {
      if (!done && x.halos.all.rank() == 0) x.counters.unsolvedPressures++;
      return iteration;
    }
    if (progress.along < 0) momentum = 1;
    const double next = 0.5 * (1 + std::sqrt(1 + 4 * momentum * momentum));
    const float ahead = static_cast<float>((momentum - 1) / next);
    momentum = next;
    const bool mayPull = x.scene.numerics.tensileLimit > 0;
    for (std::size_t i = 0; i < p.owned; i++) {
      const float k = work.stepped[i] + ahead * (work.stepped[i] - work.before[i]);
      p.trialPressure[i] = mayPull ? k : std::max(k, 0.0f);
    }
    work.before.swap(work.stepped);
  }
}

/// Records impulses and work of walls, clamps and drives in a solve. `record` takes an impulse (N s).
template<class Record> void recordReactions(const PressureSystem& x, Record record) {
  Continuum& p = x.particles;
  const auto give = [&](std::size_t i, const Vec3d& impulse, const Vec3d& velocity) {
    record(impulse);
    const double done = dot(impulse, velocity);
    if (done == 0) return;
    x.ledger.wallWork.add(done);
    p.dissipated[i] += done;  // compensated by the velocity change
  };
  for (const WallSlope& wall : x.pressure.walls) {
    if (p.clamped.active && p.clamped[wall.row])
      continue;  // the constraint of the clamped particle bears
                 // this impulse
    const double V = restVolumeOf(p, x.scene.materials, wall.row);
    give(wall.row, wall.slope * (-V * static_cast<double>(p.trialPressure[wall.row])), wall.velocity);
  }
  if (!p.clamped.active) return;
  for (const WallSlope& wall : x.pressure.walls) {  // leaves only the pair impulses: the impulse of a wall on
                                                    // a clamped particle acts between two constraints
    const double V = restVolumeOf(p, x.scene.materials, wall.row);
    if (p.clamped[wall.row])
      x.pressure.impulse[wall.row] += wall.slope * (V * static_cast<double>(p.trialPressure[wall.row]));
  }
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.clamped[i]) give(i, -x.pressure.impulse[i], p.clamped[i] == driven ? p.velocity[i] : Vec3d{});
}

/// Stops liquid without supporting pressure, such as a single drop, a quarter of a spacing from a wall.
/// Changes trialVelocity.
template<class Record> void stopAtWalls(const PressureSystem& x, double dt, Record record) {
  Continuum& p = x.particles;
  for (const WallContact& c : x.wallContacts.list) {
    const double f = static_cast<double>(x.pressure.fraction[c.row]),
                 room = std::max(0.0, c.distance - 0.25 * x.scene.spacing);
    if (f == 0 || isRigid(p, c.row) || (p.clamped.active && p.clamped[c.row])) continue;
    const Vec3d v = wallVelocity(x.walls.list[c.wall], p.position[c.row]);
    const double excess = -dot(p.trialVelocity[c.row] - v, c.normal) - room / dt;
    if (excess <= 0) continue;
    const Vec3d change = c.normal * (f * excess), impulse = change * p.mass[c.row];
    p.trialVelocity[c.row] += change;
    record(impulse);
    const double done = dot(impulse, v);
    x.ledger.wallWork.add(done);
    p.dissipated[c.row] += done;
  }
}

/// Starts from the pressure of the last step. Newly frozen particles start from 0. Whether pairs of solids
/// are listed depends on the group, and so on the number of ranks.
void setTrial(Continuum& p, const PressureWork& work, const Column<float>& pressure, double dt) {
  for (std::size_t i = 0; i < p.owned; i++)
    p.trialPressure[i] = work.response[i] > 0 ? static_cast<float>(static_cast<double>(pressure[i]) * dt) : 0;
}

void keepTrial(const Continuum& p, Column<float>& pressure, double dt) {
  for (std::size_t i = 0; i < p.owned; i++)
    pressure[i] = static_cast<float>(static_cast<double>(p.trialPressure[i]) / dt);
}

/// Corrects the dissipation of resistive forces, which was recorded at the drift velocity v. In the past half
/// kick the mean velocity is v + a dt/4. In the next one it is v + a dt/2 + pressure change + a next/4. The
/// difference is significant for steps near the viscous limit. Implicit viscous forces were recorded at the
/// mean velocity of both half kicks, so only the pressure change is missing.
void recordResistance(Continuum& p, const std::vector<Vec3d>& before, double dt, double next) {
  const double both = (dt + next) * (dt + next) / 8, half = 0.5 * next;
  const bool implicit = p.viscousAcceleration.active;
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.clamped.active && p.clamped[i]) continue;
    const Vec3d pressure = (p.velocity[i] + p.pressureImpulse[i] - before[i]) * half;
    p.dissipated[i] -= dot(p.drag[i], pressure + p.acceleration[i] * both);
    if (implicit) p.dissipated[i] -= p.mass[i] * dot(p.viscousAcceleration[i], pressure);
  }
}

/// Changes the velocity by `change`; the loss of kinetic energy is dissipated.
void change(Continuum& p, std::size_t i, const Vec3d& change) {
  p.dissipated[i] -= p.mass[i] * dot(change, p.velocity[i] + change * 0.5);
  p.velocity[i] += change;
}

/// Divergence solve: removes compression rates from the velocities.
void solveDivergence(const PressureSystem& x, double dt, double next, double share) {
  Continuum& p = x.particles;
  std::copy_n(p.velocity.data(), p.owned, x.pressure.start.begin());
  setTrial(p, x.pressure, p.divergencePressure, dt);
  x.pressureIterations.divergence = solve(x, {next, share * x.scene.numerics.divergenceTolerance, 0});
  keepTrial(p, p.divergencePressure, dt);
  recordReactions(x, [&](const Vec3d& impulse) {
    for (int a = 0; a < 3; a++) x.ledger.wallImpulse[a].add(impulse[a]);
  });
  for (std::size_t i = 0; i < p.owned; i++)
    if (!isRigid(p, i)) change(p, i, p.trialVelocity[i] - p.velocity[i]);
  if (x.joint) x.joint->kick();
}

/// Density solve: finds the kick with which the next drift ends at the target density.
void solveDensity(const PressureSystem& x, double next, double share) {
  Continuum& p = x.particles;
  PressureWork& work = x.pressure;
  const double half = 0.5 * next;
  for (std::size_t i = 0; i < p.owned; i++) work.start[i] = p.velocity[i] + p.acceleration[i] * half;
  setTrial(p, work, p.densityPressure, next);
  x.pressureIterations.density = solve(
      x, {next, share * x.scene.numerics.densityTolerance, share, meanCompression(x)});
  keepTrial(p, p.densityPressure, next);
  const auto record = [&](const Vec3d& impulse) {  // applied in the next half kick
    for (int a = 0; a < 3; a++) x.ledger.wallForce[a].add(impulse[a] / half);
  };
  recordReactions(x, record);
  stopAtWalls(x, next, record);
  for (std::size_t i = 0; i < p.owned; i++) p.pressureImpulse[i] = p.trialVelocity[i] - work.start[i];
  if (x.joint) x.joint->keep();
}

}  // namespace

void addPressureImpulse(Continuum& p) {
  for (std::size_t i = 0; i < p.owned; i++)
    if (!isRigid(p, i)) change(p, i, p.pressureImpulse[i]);
}

void findPressure(const PressureSystem& x, double dt) {
  Continuum& p = x.particles;
  // At the end of the scene the next step is unlimited.
  const double planned = nextStep(x.clock), next = std::isfinite(planned) ? planned : dt;
  std::vector<Vec3d>& before = x.pressure.arrived;
  before.assign(p.velocity.data(), p.velocity.data() + p.owned);
  const double share = std::min(1.0, next / x.pressure.correctionTime);
  prepareSystem(x);
  solveDivergence(x, dt, next, share);
  solveDensity(x, next, share);
  recordResistance(p, before, dt, next);
  if (x.halos.all.rank() == 0) {
    x.counters.densityIterations += x.pressureIterations.density;
    x.counters.divergenceIterations += x.pressureIterations.divergence;
  }
  x.times.lap(StepPhase::Pressure);
}

}  // namespace thaw
