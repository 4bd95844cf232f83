// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/halo/exchange.hpp"
#include "core/math/exact_sum.hpp"
#include "core/oriented/forces/fields.hpp"
#include "core/oriented/forces/oriented_forces.hpp"
#include "core/oriented/integrators/integrators.hpp"

namespace thaw {
namespace {

constexpr int mostIterations = 100;
constexpr double tolerance = 1e-8;  // relative norm of the residual

/// Returns the sum of dot products, the same on any number of ranks.
double product(Reducer& all, const std::vector<Vec3d>& a, const std::vector<Vec3d>& b,
               const std::vector<Vec3d>& c, const std::vector<Vec3d>& d) {
  ExactSum sum;
  for (std::size_t i = 0; i < a.size(); i++) sum.add(dot(a[i], b[i]) + dot(c[i], d[i]));
  sum.carry();
  all.sum(sum.digit);
  sum.pending = 0;
  return sum.value();
}

/// Adds K u of a pair for its first particle. K includes the squared terms of the energy, linearised, with
/// positive weights.
void addPair(const PairPotential& p, const Vec3d& r, const Vec3d (&n)[2], bool oriented, const Vec3d (&v)[2],
             const Vec3d (&spin)[2], Vec3d& force, Vec3d& torque) {
  const double r2 = dot(r, r), far = std::sqrt(r2);
  if (!(far < p.reach) || !(far > 0)) return;
  const double cosine = dot(n[0], n[1]), face = p.facing ? smoothRamp(2 * cosine).value : 1;
  const double share = p.scale * face * smoothRamp((p.reach - far) / (p.reach - p.fade)).value;
  if (share == 0) return;
  const Vec3d apart = v[1] - v[0], along = r / far;
  const double stretch = std::max(0.0, radialPart(p, far).curvature) * p.attract * share;
  force += (-stretch * dot(along, apart)) * along;
  if (!oriented) return;
  const double s2 = 1 / (p.spacing * p.spacing), across = 1 / (p.a * p.a), deep = 1 / (p.b * p.b);
  double psi[2], rate[2];
  for (int k = 0; k < 2; k++) {
    const double h = dot(n[k], r);
    psi[k] = std::exp(-0.5 * ((r2 - h * h) * across + h * h * deep));
    rate[k] = dot(n[k], apart) + dot(spin[k], cross(n[k], r));  // rate of n_k . r
  }
  const Vec3d lever = cross(n[0], r);
  // term weight g^2 with g = byNormals . r; own is 1 if n_0 occurs in g
  const auto square = [&](double weight, double change, const Vec3d& byNormals, double own) {
    force += (-2 * weight * change) * byNormals;
    torque += (2 * weight * change * own) * lever;
  };
  square(share * p.plane * s2 * psi[0], rate[0], n[0], 1);
  square(share * p.plane * s2 * psi[1], rate[1], n[1], 0);
  const double mean = 0.5 * (psi[0] + psi[1]);
  square(share * p.circle * s2 * mean, rate[0] + rate[1], n[0] + n[1], 1);
  const Vec3d bend = cross(spin[0], n[0]) - cross(spin[1], n[1]);
  torque += (2 * share * p.normal * mean) * cross(n[0], bend);
}

/// Computes image = K u for owned rows, with u in Oriented::search and searchSpin. Collective.
void multiply(Oriented& o, OrientedWork& work, Halos halos) {
  refresh(*halos.bodyTypes[orientedType], o, ColumnList{&o.search, &o.searchSpin}).wait();
  const OrientedLists& l = work.lists;
  for (std::size_t i = 0; i < o.owned; i++) {
    Vec3d force{}, torque{};
    for (std::uint32_t k = l.first[i]; k < l.first[i + 1]; k++) {
      const std::uint32_t j = l.list[k];
      if (!sameSurface(o, i, j)) continue;
      const Vec3d n[2] = {o.normal[i], o.normal[j]}, v[2] = {o.search[i], o.search[j]},
                  spin[2] = {o.searchSpin[i], o.searchSpin[j]};
      addPair(potentialOf(work, o, i, j), o.position[j] - o.position[i], n,
              ((o.flags[i] | o.flags[j]) & creased) == 0, v, spin, force, torque);
    }
    work.image[i] = force;
    work.imageSpin[i] = torque;
  }
}

const OrientedBody& bodyOfRow(const OrientedView& w, std::size_t i) {
  return w.scene.oriented[w.oriented.rows.body[i]];
}

/// Computes image = A u for owned rows, with A = M (1 + c dt) + dt^2 K and u in Oriented::search and
/// searchSpin. Constrained components are 0. Collective.
void multiplySystem(const OrientedView& w, Halos halos, double dt) {
  Oriented& o = w.oriented.rows;
  OrientedWork& work = w.work;
  multiply(o, work, halos);
  for (std::size_t i = 0; i < o.owned; i++) {
    const OrientedBody& body = bodyOfRow(w, i);
    work.image[i] = o.flags[i] & fixedPosition
                        ? Vec3d{}
                        : (o.mass[i] * (1 + body.damping * dt)) * o.search[i] + (dt * dt) * work.image[i];
    work.imageSpin[i] = o.flags[i] & fixedOrientation
                            ? Vec3d{}
                            : (o.inertia[i] * (1 + body.spinDamping * dt)) * o.searchSpin[i] +
                                  (dt * dt) * work.imageSpin[i];
    if (body.planar) {
      work.image[i].y = 0;
      work.imageSpin[i].x = work.imageSpin[i].z = 0;
    }
  }
}

/// Sets the initial solution (the current velocities), its residual, and the first search direction.
/// Collective.
void beginSolve(const OrientedView& w, Halos halos, double dt) {
  Oriented& o = w.oriented.rows;
  OrientedWork& work = w.work;
  const Vec3d g = w.scene.domain.gravity;
  for (auto* v : {&work.rest, &work.restSpin, &work.along, &work.alongSpin, &work.image, &work.imageSpin,
                  &work.velocity, &work.spin})
    v->assign(o.owned, {});
  for (std::size_t i = 0; i < o.owned; i++) {
    work.velocity[i] = o.search[i] = o.velocity[i];
    work.spin[i] = o.searchSpin[i] = o.spin[i];
  }
  multiplySystem(w, halos, dt);
  for (std::size_t i = 0; i < o.owned; i++) {
    if (!(o.flags[i] & fixedPosition))
      work.rest[i] = o.mass[i] * o.velocity[i] + dt * (o.force[i] + o.mass[i] * g) - work.image[i];
    if (!(o.flags[i] & fixedOrientation))
      work.restSpin[i] = o.inertia[i] * o.spin[i] + dt * o.torque[i] - work.imageSpin[i];
    work.along[i] = work.rest[i];
    work.alongSpin[i] = work.restSpin[i];
  }
}

/// Solves A u = M v + dt f by conjugate gradients, into OrientedWork::velocity and spin. There is no
/// preconditioner: masses are similar, and inertia is mass times spacing^2. Collective.
void solveVelocities(const OrientedView& w, Halos halos, double dt) {
  Oriented& o = w.oriented.rows;
  OrientedWork& work = w.work;
  const std::size_t n = o.owned;
  beginSolve(w, halos, dt);
  double residual2 = product(halos.all, work.rest, work.rest, work.restSpin, work.restSpin);
  const double target2 = tolerance * tolerance * residual2;
  work.solves++;
  for (int k = 0; k < mostIterations && residual2 > target2 && residual2 > 0; k++) {
    work.iterations++;
    for (std::size_t i = 0; i < n; i++) {
      o.search[i] = work.along[i];
      o.searchSpin[i] = work.alongSpin[i];
    }
    multiplySystem(w, halos, dt);
    const double step = residual2 /
                        product(halos.all, work.along, work.image, work.alongSpin, work.imageSpin);
    for (std::size_t i = 0; i < n; i++) {
      work.velocity[i] += step * work.along[i];
      work.spin[i] += step * work.alongSpin[i];
      work.rest[i] -= step * work.image[i];
      work.restSpin[i] -= step * work.imageSpin[i];
    }
    const double now = product(halos.all, work.rest, work.rest, work.restSpin, work.restSpin);
    for (std::size_t i = 0; i < n; i++) {
      work.along[i] = work.rest[i] + (now / residual2) * work.along[i];
      work.alongSpin[i] = work.restSpin[i] + (now / residual2) * work.alongSpin[i];
    }
    residual2 = now;
  }
}

/// Moves a row by the solved velocity. Records dissipation by damping and by the scheme, (dv M dv + dt^2 v K
/// v) / 2. Requires: OrientedWork::acting, and K v in image.
void translateRow(const OrientedView& w, std::size_t i, double dt) {
  Oriented& o = w.oriented.rows;
  const OrientedBody& body = bodyOfRow(w, i);
  // uses the pair forces of the solution, because they conserve momentum, unlike the solver's residual
  const Vec3d solved = w.work.velocity[i],
              v = o.velocity[i] +
                  dt * (w.work.acting[i] / o.mass[i] + w.scene.domain.gravity - body.damping * solved),
              dv = v - o.velocity[i];
  o.dissipated[i] += o.mass[i] * (body.damping * dt * dot(v, solved) + 0.5 * dot(dv, dv)) +
                     0.5 * dt * dt * dot(v, w.work.image[i]);
  for (int a = 0; a < 3; a++)
    if (const double lost = -dt * body.damping * o.mass[i] * solved[a]; lost != 0)
      w.ledger.wallImpulse[a].add(lost);
  // at the old position, before the move
  if (const double given = dt * dot(fieldForce(w, i).force, v); given != 0) w.ledger.wallWork.add(given);
  o.velocity[i] = v;
  o.position[i] += dt * v;
}

/// Rotates a row by the solved angular velocity, and records dissipation as translateRow.
void rotateRow(const OrientedView& w, std::size_t i, double dt) {
  Oriented& o = w.oriented.rows;
  const Vec3d spin = w.work.spin[i], change = spin - o.spin[i];
  o.dissipated[i] += o.inertia[i] *
                         (bodyOfRow(w, i).spinDamping * dt * dot(spin, spin) + 0.5 * dot(change, change)) +
                     0.5 * dt * dt * dot(spin, w.work.imageSpin[i]);
  o.spin[i] = spin;
  o.orientation[i] = unitQuat(rotationBy(dt * spin) * o.orientation[i]);
}

}  // namespace

void stepSemiImplicit(const OrientedView& w, Halos halos, double dt) {
  Oriented& o = w.oriented.rows;
  OrientedWork& work = w.work;
  recordObstacleWork(w, dt);
  work.acting.assign(o.owned, {});
  work.actingTorque.assign(o.owned, {});
  solveVelocities(w, halos, dt);
  for (std::size_t i = 0; i < o.owned; i++) {
    o.search[i] = work.velocity[i];
    o.searchSpin[i] = work.spin[i];
  }
  multiply(o, work, halos);
  for (std::size_t i = 0; i < o.owned; i++) {
    if (bodyOfRow(w, i).planar) work.image[i].y = 0;
    work.acting[i] = o.force[i] - dt * work.image[i];
    work.actingTorque[i] = o.torque[i] - dt * work.imageSpin[i];
    if (!(o.flags[i] & fixedPosition)) translateRow(w, i, dt);
    if (!(o.flags[i] & fixedOrientation)) rotateRow(w, i, dt);
  }
}

}  // namespace thaw
