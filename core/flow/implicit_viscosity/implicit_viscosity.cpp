// SPDX-License-Identifier: Apache-2.0
#include "core/flow/implicit_viscosity/implicit_viscosity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/halo/exchange.hpp"

namespace thaw {
namespace {

/// Short names for the data that the solver uses.
struct Solver {
  const WallView& w;
  Halos& halos;
  const ViscosityView& view;
  const PairSums& sums;
  const WallContext& at;
  ViscousWork& work;
  Continuum& p;
  double dt;
  bool known(std::size_t i) const { return p.clamped.active && p.clamped[i]; }
};

void resize(Solver& s) {
  const std::size_t n = s.p.owned, rows = n + s.view.ghostRoom + 1;
  ViscousWork& k = s.work;
  if (k.records.size() < rows) {
    k.records.resize(rows);
    k.middle.resize(rows);
  }
  if (k.goal.size() < n) {
    const std::size_t room = n + n / 4;
    for (auto* v : {&k.goal, &k.solution, &k.residual, &k.product, &k.ready}) v->resize(room);
    k.block.resize(room);
  }
}

/// Packs viscosity and liquid fraction of all rows, which are constant during the solve.
template<class Real> void packParameters(Solver& s) {
  struct Four {
    Real a, b, c, d;
  };
  const auto* velocityViscosity = static_cast<const Four*>(s.sums.velocityViscosity);
  const auto* pressurePhaseHeat = static_cast<const Four*>(s.sums.pressurePhaseHeat);
  for (std::size_t i = 0; i < s.p.size(); i++) {
    s.work.records[i].viscosity = static_cast<float>(velocityViscosity[i].d);
    s.work.records[i].liquid = static_cast<float>(pressurePhaseHeat[i].b);
  }
  const std::size_t dummy = s.view.neighbours.dummy;
  s.work.records[dummy] = s.work.middle[dummy] = {};
}

void packVelocities(Solver& s, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; i++) {
    const Vec3d& v = s.p.viscousSearch[i];
    ViscousRecord& r = s.work.records[i];
    r.x = v.x;
    r.y = v.y;
    r.z = v.z;
  }
}

/// Sets product = L times the velocities in viscousSearch. The velocities are sent to ghosts meanwhile.
void applyPairs(Solver& s, ViscousPass pass) {
  Continuum& p = s.p;
  ViscousWork& k = s.work;
  const NeighbourLists& lists = s.view.neighbours;
  ViscousSums out;
  out.pass = pass;
  out.velocity = k.records.data();
  out.middle = k.middle.data();
  out.result = k.product.data();
  out.block = k.block.data();
  out.lost = p.dissipation.data();
  s.view.times.lap(StepPhase::Viscosity);
  Exchange ghosts = refresh(s.halos.cells, p, ColumnList{&p.viscousSearch});
  s.view.times.lap(StepPhase::Exchange);
  packVelocities(s, 0, p.owned);
  std::fill_n(k.product.begin(), p.owned, Vec3d{});
  if (pass == ViscousPass::Start) std::fill_n(k.block.begin(), p.owned, Sym3d{});
  // Mean velocities before and after the kick.
  const auto packMiddle = [&](std::size_t begin, std::size_t end) {
    if (pass != ViscousPass::Force) return;
    for (std::size_t i = begin; i < end; i++) {
      const Vec3d m = 0.5 * (p.velocity[i] + p.viscousSearch[i]);
      k.middle[i] = {m.x, m.y, m.z};
    }
  };
  packMiddle(0, p.owned);
  s.view.kernels.viscous(s.sums, out, {0, lists.innerGroups});
  s.view.times.lap(StepPhase::Viscosity);
  ghosts.wait();
  s.view.times.lap(StepPhase::Exchange);
  packVelocities(s, p.owned, p.size());
  packMiddle(p.owned, p.size());
  s.view.kernels.viscous(s.sums, out, {lists.innerGroups, lists.groups});
}

void listWalls(Solver& s) {
  s.work.walls.clear();
  for (const WallContact& c : s.view.wallContacts.list) {
    const double drag = wallDrag(s.at, c);
    if (drag > 0)
      s.work.walls.push_back(
          {c.row, c.wall, drag, c.normal, wallVelocity(s.w.walls.list[c.wall], s.p.position[c.row])});
  }
}

Sym3d inverse(const Sym3d& a) {
  const double xx = a.yy * a.zz - a.yz * a.yz, xy = a.xz * a.yz - a.xy * a.zz, xz = a.xy * a.yz - a.xz * a.yy;
  const double d = 1 / (a.xx * xx + a.xy * xy + a.xz * xz);
  return {d * xx, d * (a.xx * a.zz - a.xz * a.xz), d * (a.xx * a.yy - a.xy * a.xy),
          d * xy, d * (a.xy * a.xz - a.xx * a.yz), d * xz};
}

/// Exact sums over the particles of all ranks, with the same bits on any number of ranks.
template<std::size_t n> std::array<double, n> sumOver(Solver& s, std::array<ExactSum, n>& sum) {
  std::array<std::int64_t, n * ExactSum::digits> digit;
  for (std::size_t k = 0; k < n; k++) {
    sum[k].carry();
    std::copy(sum[k].digit.begin(), sum[k].digit.end(),
              digit.begin() + static_cast<std::ptrdiff_t>(k * ExactSum::digits));
  }
  s.view.times.lap(StepPhase::Viscosity);
  s.halos.all.sum(digit);
  s.view.times.lap(StepPhase::Reduce);
  std::array<double, n> value;
  for (std::size_t k = 0; k < n; k++) {
    std::copy_n(digit.begin() + static_cast<std::ptrdiff_t>(k * ExactSum::digits), ExactSum::digits,
                sum[k].digit.begin());
    value[k] = sum[k].value();
  }
  return value;
}

/// Convergence state of the iteration.
struct Progress {
  double steepness = 0;  ///< r . P^-1 r
  double excess = 0;     ///< |error|^2 minus the tolerance, kg m^2/s^2; converged if at most 0
};

/// Makes the velocities (m/s) of the particles in rigid pieces those of rigid motion. Collective.
void join(Solver& s, Vec3d* velocities) {
  if (s.view.joint) s.view.joint->join({velocities, s.p.owned});
}

/// Preconditions the residual, and compares the velocity error M^-1 r with the velocity change by viscosity,
/// u - goal. A millionth of the goal is added for bodies in rigid motion, in which viscosity changes nothing.
Progress assess(Solver& s) {
  ViscousWork& k = s.work;
  const double tolerance2 = s.w.scene.numerics.viscosityTolerance * s.w.scene.numerics.viscosityTolerance;
  std::array<ExactSum, 2> sum;
  for (std::size_t i = 0; i < s.p.owned; i++)
    k.ready[i] = isRigid(s.p, i) ? k.residual[i] / s.p.mass[i] : k.block[i] * k.residual[i];
  join(s, k.ready.data());
  for (std::size_t i = 0; i < s.p.owned; i++) {
    const Vec3d &r = k.residual[i], change = k.solution[i] - k.goal[i];
    sum[0].add(dot(r, k.ready[i]));
    const double m = s.p.mass[i];
    // For a rigid piece, only the part of the residual that moves the piece counts.
    const double error2 = isRigid(s.p, i) ? m * dot(k.ready[i], k.ready[i]) : dot(r, r) / m;
    sum[1].add(error2 - tolerance2 * m * (dot(change, change) + 1e-12 * dot(k.goal[i], k.goal[i])));
  }
  const std::array<double, 2> v = sumOver(s, sum);
  return {v[0], v[1]};
}

/// Sets the initial velocities, the first residual and the preconditioner.
void begin(Solver& s) {
  Continuum& p = s.p;
  ViscousWork& k = s.work;
  for (std::size_t i = 0; i < p.owned; i++) k.ready[i] = p.force[i] / p.mass[i];
  join(s, k.ready.data());
  for (std::size_t i = 0; i < p.owned; i++) {
    k.goal[i] = k.solution[i] = p.velocity[i];
    if (!s.known(i)) {
      k.goal[i] += s.dt * (k.ready[i] + s.w.scene.domain.gravity);
      k.solution[i] = k.goal[i] + s.dt * p.viscousAcceleration[i];
    }
    p.viscousSearch[i] = k.solution[i];
  }
  applyPairs(s, ViscousPass::Start);
  for (const ViscousWall& c : k.walls) {
    k.product[c.row] += c.along(k.solution[c.row] - c.velocity);
    const Vec3d& n = c.normal;
    const double d = c.drag;
    k.block[c.row] = k.block[c.row] + Sym3d{d * (1 - n.x * n.x), d * (1 - n.y * n.y), d * (1 - n.z * n.z),
                                            -d * n.x * n.y,      -d * n.y * n.z,      -d * n.x * n.z};
  }
  for (std::size_t i = 0; i < p.owned; i++) {
    const double m = p.mass[i];
    k.residual[i] = s.known(i) ? Vec3d{} : m * (k.goal[i] - k.solution[i]) - s.dt * k.product[i];
    k.block[i] = inverse(Sym3d{m, m, m, 0, 0, 0} + s.dt * k.block[i]);
  }
}

/// Conjugate gradients (HS52), preconditioned by the particles' own 3x3 blocks. Returns
/// true on convergence.
bool iterate(Solver& s) {
  Continuum& p = s.p;
  ViscousWork& k = s.work;
  k.iterations = 0;
  Progress now = assess(s);
  for (std::size_t i = 0; i < p.owned; i++) p.viscousSearch[i] = k.ready[i];
  for (; now.excess > 0 && k.iterations < s.w.scene.numerics.viscosityIterations; k.iterations++) {
    applyPairs(s, ViscousPass::Apply);
    for (const ViscousWall& c : k.walls) k.product[c.row] += c.along(p.viscousSearch[c.row]);
    std::array<ExactSum, 1> curvature;
    for (std::size_t i = 0; i < p.owned; i++) {
      k.product[i] = s.known(i) ? Vec3d{} : p.mass[i] * p.viscousSearch[i] + s.dt * k.product[i];
      curvature[0].add(dot(p.viscousSearch[i], k.product[i]));
    }
    const double length = now.steepness / sumOver(s, curvature)[0];
    for (std::size_t i = 0; i < p.owned; i++) {
      k.solution[i] += length * p.viscousSearch[i];
      k.residual[i] -= length * k.product[i];
    }
    const Progress next = assess(s);
    const double turn = next.steepness / now.steepness;
    for (std::size_t i = 0; i < p.owned; i++) p.viscousSearch[i] = k.ready[i] + turn * p.viscousSearch[i];
    now = next;
  }
  return !(now.excess > 0);
}

/// Adds the forces for the solution and records their energies. Dissipation uses the mid-point velocity of
/// the last iterate. The work of the remaining residual is recorded, too.
void addForces(Solver& s) {
  Continuum& p = s.p;
  ViscousWork& k = s.work;
  Ledger& l = s.w.ledger;
  for (std::size_t i = 0; i < p.owned; i++) p.viscousSearch[i] = k.solution[i];
  applyPairs(s, ViscousPass::Force);
  for (const ViscousWall& c : k.walls) {
    const std::size_t i = c.row;
    const Vec3d f = -c.along(k.solution[i] - c.velocity);
    k.product[i] -= f;
    p.dissipation[i] -= dot(f, 0.5 * (p.velocity[i] + k.solution[i]) - c.velocity);
    for (int a = 0; a < 3; a++) l.wallForce[a].add(f[a]);
    if (!s.w.walls.list[c.wall].properties.motion.empty()) l.wallWork.add(dot(f, c.velocity) * s.at.dt);
  }
  const Vec3d g = s.w.scene.domain.gravity;
  for (std::size_t i = 0; i < p.owned; i++) {
    const Vec3d f = -k.product[i];
    const double m = p.mass[i];
    p.force[i] += f;
    if (s.known(i)) {  // the constraint balances this force too
      for (int a = 0; a < 3; a++) l.wallForce[a].add(-f[a]);
      if (p.clamped[i] == driven) l.wallWork.add(-dot(f, p.velocity[i]) * s.at.dt);
      p.viscousAcceleration[i] = {};
      continue;
    }
    p.viscousAcceleration[i] = f / m;
  }
  for (std::size_t i = 0; i < p.owned; i++) k.ready[i] = p.force[i] / p.mass[i];
  join(s, k.ready.data());
  join(s, p.viscousAcceleration.data());
  for (std::size_t i = 0; i < p.owned; i++) {
    if (s.known(i)) continue;
    const Vec3d end = p.velocity[i] + s.dt * (k.ready[i] + g);
    p.dissipation[i] += 0.5 * dot(k.product[i], end - k.solution[i]);
  }
  s.view.times.lap(StepPhase::Viscosity);
}

}  // namespace

void addImplicitViscosity(const ViscosityView& view, Halos halos, const PairSums& sums,
                          const WallContext& walls) {
  const WallView& w = walls.world;
  Solver s{w, halos, view, sums, walls, view.viscous, w.particles, walls.span};
  resize(s);
  w.scene.numerics.precision == Precision::Single ? packParameters<float>(s) : packParameters<double>(s);
  listWalls(s);
  begin(s);
  const bool done = iterate(s);
  addForces(s);
  if (halos.all.rank() == 0) {
    w.counters.viscousIterations += view.viscous.iterations;
    w.counters.viscousUnfinished += !done;
  }
}

}  // namespace thaw
