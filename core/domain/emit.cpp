// SPDX-License-Identifier: Apache-2.0
#include "core/domain/emit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/domain/outside.hpp"
#include "core/fluid/laws/cohesion.hpp"
#include "core/fluid/laws/surface_energy.hpp"
#include "core/geometry/basic/shape_error.hpp"
#include "core/materials/surface_tension.hpp"
#include "core/math/digits.hpp"
#include "core/math/tangent.hpp"
#include "core/scene/field_values.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/phase_density.hpp"

namespace thaw {
namespace {

constexpr double mostInLayer = 1e6;

/// Density at rest (kg/m^3) of an emitter's particles, at the emitter's temperature. If its temperature field
/// crosses the melting temperature, the rest volume of some particles differs.
double emittedDensity(const Scene& s, const Emitter& e) {
  const Material& m = s.materials[static_cast<std::size_t>(e.material)];
  return solidAt(m, e.temperature) ? solidDensityOf(m) : m.density;
}

/// Sets u and v to unit vectors perpendicular to n. The rule is fixed, so every rank and run makes the same
/// layers.
void across(const Vec3d& n, Vec3d& u, Vec3d& v) {
  const Vec3d axis = leastAxis(n);
  u = normalized(axis - n * dot(axis, n));
  v = cross(n, u);
}

/// Returns coordinates (m) of the lattice points that fit into an extent (m), symmetric about its middle.
std::vector<double> centred(double extent, double spacing) {
  const int n = std::max(1, static_cast<int>(std::floor(extent / spacing + 1e-9)));
  std::vector<double> x;
  for (int k = 0; k < n; k++) x.push_back((k - 0.5 * (n - 1)) * spacing);
  return x;
}

/// Time (s) that a layer spends in the nozzle. The nozzle is one support radius long, or shorter if the
/// domain ends earlier.
double nozzleTime(const Scene& s, const Emitter& e, const EmitterPlan& plan) {
  const double distance = plan.interval * e.speed;
  const Vec3d n = normalized(e.direction);
  for (int layers = static_cast<int>(std::ceil(s.numerics.support * s.spacing / distance)); layers > 0;
       layers--) {
    bool inside = true;
    for (std::size_t k = 0; k < plan.layer.size(); k++)
      for (int a = 0; a < 3; a++) {
        const double back = plan.velocity.empty()
                                ? plan.layer[k][a] - n[a] * distance * layers
                                : plan.layer[k][a] - plan.velocity[k][a] * (layers * plan.interval);
        inside = inside && back > s.domain.min[a] && back < s.domain.max[a];
      }
    if (inside) return layers * plan.interval;
  }
  return 0;
}

/// Returns EmitterPlan::cohesion (J) for pairwise tension, with the potential of the force sums (Cohesion).
std::vector<std::vector<double>> cohesionOf(const Scene& s, const Emitter& e, const EmitterPlan& plan) {
  using isa_base::Cohesion;
  const Material& m = s.materials[static_cast<std::size_t>(e.material)];
  std::vector<std::vector<double>> energy;
  if (!(m.surfaceTension > 0) || s.numerics.tension != TensionForm::Pairwise) return energy;
  const double h = s.numerics.support * s.spacing, V = plan.particleMass / emittedDensity(s, e) / (h * h * h);
  const double strength = Cohesion::scale * V * V * m.surfaceTension * h * h;
  const double distance = plan.interval * e.speed;
  for (int layer = 0; layer * distance < h && layer * plan.interval <= plan.ahead; layer++) {
    energy.emplace_back(plan.layer.size());
    // Positions are sorted along `a`: only those within h of i are visited.
    std::size_t first = 0;
    for (std::size_t i = 0; i < plan.layer.size(); i++) {
      while (plan.along[i] - plan.along[first] >= h) first++;
      for (std::size_t j = first; j < plan.layer.size() && plan.along[j] - plan.along[i] < h; j++) {
        const Vec3d d = plan.layer[i] - plan.layer[j];
        const double q = std::sqrt(dot(d, d) + layer * distance * layer * distance) / h;
        if ((layer > 0 || i != j) && q < 1)
          energy.back()[i] += (layer > 0 ? 1 : 0.5) * strength * Cohesion::potential(q);
      }
    }
  }
  return energy;
}

/// Returns EmitterPlan::cohesion (J) for tension by surface energy. E(m) is the energy of a stack of m layers
/// (findSurfaceEnergy). Element [m] is E(m + 1) - 2 E(m) + E(m - 1) per particle of a layer.
std::vector<std::vector<double>> surfaceEnergyOf(const Scene& s, const Emitter& e, const EmitterPlan& plan) {
  const Material& m = s.materials[static_cast<std::size_t>(e.material)];
  std::vector<std::vector<double>> energy;
  if (!(m.surfaceTension > 0) || s.numerics.tension != TensionForm::SurfaceEnergy) return energy;
  const double h = s.numerics.support * s.spacing, V = plan.particleMass / emittedDensity(s, e),
               distance = plan.interval * e.speed, volume = V / (h * h * h);
  const int reach = static_cast<int>(std::floor(h / distance)), layers = 2 * reach + 2;
  const SurfaceMeasure measure = surfaceMeasure(s.numerics, s.spacing);
  // Gradient and colour due to a layer k layers away, in a frame with x along the direction.
  std::vector<std::vector<SurfaceKernelValue>> by;
  const Vec3d n = normalized(e.direction);
  for (int k = 0; k <= reach; k++) {
    by.emplace_back(plan.layer.size());
    std::size_t first = 0;
    for (std::size_t i = 0; i < plan.layer.size(); i++) {
      while (plan.along[i] - plan.along[first] >= h) first++;
      for (std::size_t j = first; j < plan.layer.size() && plan.along[j] - plan.along[i] < h; j++) {
        if (k == 0 && i == j) continue;
        const SurfaceKernelValue share = surfaceKernelAt(
            (plan.layer[i] - plan.layer[j] + n * (k * distance)) / h);
        by.back()[i].gradient += share.gradient * volume;
        by.back()[i].colour += share.colour * volume;
      }
    }
  }
  double before = 0, added = 0;
  for (int count = 1; count <= layers; count++) {
    double total = 0;
    for (int l = 0; l < count; l++)
      for (std::size_t i = 0; i < plan.layer.size(); i++) {
        SurfaceKernelValue g;
        for (int o = std::max(0, l - reach); o <= std::min(count - 1, l + reach); o++) {
          const SurfaceKernelValue& one = by[static_cast<std::size_t>(std::abs(o - l))][i];
          g.gradient += o > l ? one.gradient - n * (2 * dot(one.gradient, n)) : one.gradient;
          g.colour += one.colour;
        }
        const double T = plan.temperature.empty() ? e.temperature : plan.temperature[i];
        total += surfaceState(measure, surfaceTensionAt(m, T), g.gradient, g.colour).energy * V;
      }
    energy.emplace_back(plan.layer.size(), (total - before - added) / static_cast<double>(plan.layer.size()));
    added = total - before;
    before = total;
  }
  return energy;
}

SourcePlace placeOf(const VelocityField& f) {
  for (const PositionField& c : f.component)
    if (c) return c.where;
  return f.gradientWhere;
}

ShapeError placed(const Emitter& e, const std::string& what) {
  SceneProblems problem;
  problem.add(e.where, "emitter '" + e.name + "': " + what);
  return problem.lines();
}

/// Adds a layer's velocities and temperatures for emitters with fields. A layer leaves as a whole, so fields
/// must not change its speed along the direction.
void addFields(const Emitter& e, EmitterPlan& plan) {
  const Vec3d n = normalized(e.direction);
  SceneProblems problems;
  for (const Vec3d& x : plan.layer) {
    if (e.velocityField.given()) {
      const Vec3d across = velocityOf(e.velocityField, e.centre, x);
      for (int a = 0; a < 3; a++)
        if (!isStartSpeed(across[a])) {
          const PositionField& f = e.velocityField.component[a];
          problems.add(f.where, badValue(f, across[a], x) + ", in the opening; " + expectedSpeeds);
          return problems.raise();
        }
      if (std::abs(dot(across, n)) > 1e-6 * e.speed) {
        problems.add(placeOf(e.velocityField),
                     "emitter '" + e.name + "': its velocity field has " + inDigits(dot(across, n)) +
                         " m/s along `direction` in its opening; expected 0, since layers leave as a whole "
                         "at `speed`: use emitters of several speeds for a profile");
        return problems.raise();
      }
      plan.velocity.push_back(n * e.speed + across);
    }
    if (!e.temperatureField) continue;
    const PositionField& f = e.temperatureField;
    plan.temperature.push_back(f.value(x));
    if (isStartTemperature(plan.temperature.back())) continue;
    problems.add(f.where,
                 badValue(f, plan.temperature.back(), x) + ", in the opening; " + expectedTemperatures);
    return problems.raise();
  }
}

/// Rejects a velocity field that moves neighbours relative to each other in the nozzle.
void checkNozzle(const Scene& s, const Emitter& e, const EmitterPlan& plan) {
  if (plan.velocity.empty()) return;
  constexpr double most = 0.2;  // spacings
  double apart = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < plan.layer.size(); i++) {
    while (plan.along[i] - plan.along[first] > 1.5 * s.spacing) first++;
    for (std::size_t j = first; j < i; j++) {
      const Vec3d d = plan.layer[i] - plan.layer[j];
      if (length(d) < 1.1 * s.spacing) apart = std::max(apart, length(plan.velocity[i] - plan.velocity[j]));
    }
  }
  const double moved = apart * plan.ahead / s.spacing;
  if (moved <= most) return;
  SceneProblems problems;
  problems.add(placeOf(e.velocityField),
               "emitter '" + e.name + "': its velocity field shears the liquid in the nozzle by " +
                   inDigits(moved) + " spacings in " + inDigits(plan.ahead) + " s; expected at most " +
                   inDigits(most) + ": use a smaller field, a larger `speed` or a finer spacing");
  problems.raise();
}

}  // namespace

std::vector<EmitterPlan> planEmitters(const Scene& s) {
  std::vector<EmitterPlan> plans;
  for (const Emitter& e : s.emitters) {
    EmitterPlan plan;
    Vec3d u, v;
    across(normalized(e.direction), u, v);
    const double dx = s.spacing, across1 = e.disc ? 2 * e.radius : e.width,
                 across2 = e.disc ? across1 : e.depth;
    if (across1 / dx * (across2 / dx) > mostInLayer)
      throw placed(e, "its opening has " + inDigits(across1 / dx * (across2 / dx)) +
                          " particle positions at a spacing of " + inDigits(dx) +
                          " m, expected at most a million: reduce the opening or increase the spacing");
    for (double a : centred(across1, dx))
      for (double b : centred(across2, dx))
        if (!e.disc || a * a + b * b <= e.radius * e.radius) {
          plan.layer.push_back(e.centre + u * a + v * b);
          plan.along.push_back(a);
        }
    addFields(e, plan);
    plan.particleMass = emittedDensity(s, e) * dx * dx * dx;
    plan.interval = e.rate > 0 ? static_cast<double>(plan.layer.size()) * plan.particleMass / e.rate
                               : dx / e.speed;
    if (plan.interval * e.speed < 0.95 * dx)
      throw placed(e,
                   "a rate of " + inDigits(e.rate) +
                       " kg/s does not fit through its opening at this speed; expected at most " +
                       inDigits(static_cast<double>(plan.layer.size()) * plan.particleMass * e.speed / dx) +
                       " kg/s");
    plan.ahead = nozzleTime(s, e, plan);
    checkNozzle(s, e, plan);
    plan.cohesion = s.numerics.tension == TensionForm::SurfaceEnergy ? surfaceEnergyOf(s, e, plan)
                                                                     : cohesionOf(s, e, plan);
    plans.push_back(std::move(plan));
  }
  return plans;
}

std::string misplacedOpening(const Scene& s, const Walls& walls, const Emitter& e, const EmitterPlan& plan) {
  const auto all = static_cast<std::int64_t>(plan.layer.size());
  Outside opening;
  for (const Vec3d& x : plan.layer) opening.look(s.domain, x);
  if (opening.count > 0)
    return "emitter '" + e.name +
           "': " + outsideText(opening, s.domain, all, "positions of a layer", "emitter");
  for (const Wall& wall : walls.list) {
    const auto in = std::count_if(plan.layer.begin(), plan.layer.end(),
                                  [&](const Vec3d& x) { return holdsSample(wall, x, s.spacing); });
    if (in > 0)
      return "emitter '" + e.name + "': " + std::to_string(in) + " of its " + std::to_string(all) +
             " positions of a layer lie in obstacle '" + wall.properties.name + "'; move the emitter";
  }
  return {};
}

std::string unevenOutflow(const Scene& s, const Emitter& e, const EmitterPlan& plan) {
  const double area = e.disc ? std::numbers::pi * e.radius * e.radius : e.width * e.depth;
  const double is = outflowOf(plan), meant = emittedDensity(s, e) * area * e.speed;
  if (e.rate > 0 || std::abs(is / meant - 1) < 0.25) return {};
  return "emitter '" + e.name + "' emits " + inDigits(is) + " kg/s, but opening, speed and density imply " +
         inDigits(meant) + " kg/s: at this spacing a layer has " + std::to_string(plan.layer.size()) +
         (plan.layer.size() == 1 ? " particle" : " particles") + "; reduce the spacing or set `rate`";
}

std::int64_t layersUntil(const Emitter& e, const EmitterPlan& plan, double time) {
  if (time < e.start) return 0;
  const double until = std::min(time + plan.ahead, e.end);
  return until < e.start ? 0 : static_cast<std::int64_t>(std::floor((until - e.start) / plan.interval)) + 1;
}

double cohesionAtEntry(const EmitterPlan& plan, std::int64_t layer, std::size_t k) {
  double energy = 0;
  for (std::size_t m = 0; m < plan.cohesion.size() && static_cast<std::int64_t>(m) <= layer; m++)
    energy += plan.cohesion[m][k];
  return energy;
}

double leavingTime(const Emitter& e, const EmitterPlan& plan, std::int64_t layer) {
  return e.start + static_cast<double>(layer) * plan.interval;
}

void releaseDriven(const Scene& s, const std::vector<EmitterPlan>& plans, double time, Continuum& p) {
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.clamped[i] != driven) continue;
    const std::size_t e = sourceOf(p.id[i]) - s.bodies.size();
    const std::int64_t layer = static_cast<std::int64_t>(numberOf(p.id[i]) / plans[e].layer.size());
    if (time >= leavingTime(s.emitters[e], plans[e], layer)) p.clamped[i] = 0;
  }
}

}  // namespace thaw
