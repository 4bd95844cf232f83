// SPDX-License-Identifier: Apache-2.0
// Surface tension against exact solutions (docs/validation/accuracy.md): Laplace's pressure and the second
// mode of a drop.
#include "benchmarks/accuracy/liquid/drop_cases.hpp"
#include "core/fluid/laws/particle_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/fluid/laws/cohesion.hpp"
#include "core/fluid/laws/surface_kernel.hpp"
#include "core/kernels/kernels.hpp"
#include "core/simulation/time/integrate.hpp"

namespace thaw::accuracy {
namespace {

using std::numbers::pi;

double massOf(const World& w, std::size_t i) { return w.particles.mass[i]; }

Vec3d centreOf(Trial& r) {
  const double mass = sum(r, massOf);
  Vec3d c;
  for (int a = 0; a < 3; a++)
    c[a] = sum(r, [a](const World& w,
                      std::size_t i) { return w.particles.mass[i] * w.particles.position[i][a]; }) /
           mass;
  return c;
}

/// Radius (m) of a ball with the drop's mass at rest density.
double radiusOf(Trial& r) {
  return std::cbrt(3 * sum(r, massOf) / r.world.scene.materials[0].density / (4 * pi));
}

/// Share of the line from a to b within a ball of radius R around the origin.
double shareWithin(const Vec3d& a, const Vec3d& b, double R) {
  const Vec3d d = b - a;
  const double A = dot(d, d), B = dot(a, d), C = dot(a, a) - R * R, root2 = B * B - A * C;
  if (root2 <= 0) return 0;
  const double root = std::sqrt(root2), from = std::max(0.0, (-B - root) / A),
               to = std::min(1.0, (-B + root) / A);
  return std::max(0.0, to - from);
}

/// Inviscid force between two liquid particles along i - j, in N. The terms are those of terms/forces.hpp and
/// terms/tension.hpp.
struct PairForce {
  const World& w;
  const StepTools& t;
  double term(std::size_t i) const {
    const double relativeDensity = static_cast<double>(w.particles.relativeDensity[i]);
    return static_cast<double>(pressureOfParticle(w.scene, w.modules, w.particles, t.liquids, i)) /
           (relativeDensity * relativeDensity);
  }
  double operator()(std::size_t i, std::size_t j, double distance) const {
    const Continuum& p = w.particles;
    const Material& m = w.scene.materials[0];
    const double h = w.grid.support, q = distance / h, V = p.mass[i] / m.density / (h * h * h),
                 U = p.mass[j] / m.density / (h * h * h);
    const double slope = isa_base::WendlandC2::slope(q * q);
    const double pressure = -V * U * (term(i) + term(j)) * slope * t.sums.scales.inverseLatticeSum * q * h *
                            h;
    if (w.scene.numerics.tension != TensionForm::Pairwise) return pressure;
    return pressure - isa_base::Cohesion::scale * V * U * m.surfaceTension * h * isa_base::Cohesion::force(q);
  }
};

/// Calls action(i, j, d, distance), d = x_i - x_j, for each owned particle and each of its neighbours, ghosts
/// included.
template<class Action> void overPairs(const World& w, Action action) {
  const NeighbourLists& n = w.neighbours;
  for (std::size_t g = 0; g < n.groups; g++)
    for (std::size_t l = 0; l < 8; l++) {
      const std::uint32_t i = n.self[8 * g + l];
      if (i == n.dummy) continue;
      for (std::uint32_t k = 0; k < n.count[g]; k++) {
        const std::uint32_t j = n.row(g, k, l);
        if (j == n.dummy) continue;
        const Vec3d d = w.particles.position[i] - w.particles.position[j];
        const double distance = length(d);
        if (distance < w.grid.support && distance > 0) action(i, j, d, distance);
      }
    }
}

/// Force (N) on i from the surface energy of the pair (terms/surface_energy.hpp). It is not along i - j
/// alone. Zero for other forms of tension.
Vec3d surfaceForce(const World& w, std::size_t i, std::size_t j, const Vec3d& d) {
  const Continuum& p = w.particles;
  if (!w.modules.surfaceEnergy) return {};
  const double h = w.grid.support, rho = w.scene.materials[0].density, q2 = dot(d, d) / (h * h);
  const Vec3d x = d / h, u = p.surfaceEnergyByGradient[i] - p.surfaceEnergyByGradient[j];
  const double slope = isa_base::SurfaceKernel::slope(q2),
               bend = isa_base::SurfaceKernel::secondDerivative(q2);
  const double along = bend * dot(u, x) + slope * (p.surfaceEnergyByColour[i] + p.surfaceEnergyByColour[j]);
  return (u * slope + x * along) * (-p.mass[i] / rho * (p.mass[j] / rho) / (h * h * h * h));
}

/// Pressures averaged over a ball around the drop's centre (Irving and Kirkwood; Cormier, Rickman & Delph
/// 2001 eq. 13). Each pair force counts with the share of its line inside the ball. Momentum flow is added.
/// `pairs` holds pressure and cohesion. `all` adds the surface energy, which also acts inside where particles
/// are disordered. `mismatch` is the root mean square difference from the program's forces.
struct Within {
  double pairs, all, mismatch;
};
Within pressureWithin(Trial& r, double radius) {
  const World& w = r.world;
  const Continuum& p = w.particles;
  const PairForce pairForce{w, r.tools};
  const Vec3d centre = centreOf(r);
  std::vector<double> virial(p.owned, 0.0), surface(p.owned, 0.0);
  std::vector<Vec3d> force(p.owned);
  overPairs(w, [&](std::size_t i, std::size_t j, const Vec3d& d, double distance) {
    const double f = pairForce(i, j, distance),
                 share = shareWithin(p.position[i] - centre, p.position[j] - centre, radius);
    const Vec3d tension = surfaceForce(w, i, j, d);
    virial[i] += 0.5 * f * distance * share;
    surface[i] += 0.5 * dot(tension, d) * share;
    force[i] += d * (f / distance) + tension;
  });
  const double volume = 4 * pi / 3 * radius * radius * radius;
  const double moving = sum(r, [&](const World& x, std::size_t i) {
    return length(p.position[i] - centre) < radius ? x.particles.mass[i] * dot(p.velocity[i], p.velocity[i])
                                                   : 0;
  });
  Within in{};
  in.mismatch = rootMeanSquare(
      r, [&](const World&, std::size_t i) { return length(forceOf(w.particles, w.scene, i) - force[i]); });
  in.pairs = (sum(r, [&](const World&, std::size_t i) { return virial[i]; }) + moving) / (3 * volume);
  in.all = in.pairs + sum(r, [&](const World&, std::size_t i) { return surface[i]; }) / (3 * volume);
  return in;
}

std::vector<Figure> measureLaplace(Trial& r) {
  const World& w = r.world;
  const double R = radiusOf(r), h = w.grid.support, sigma = w.scene.materials[0].surfaceTension,
               exact = 2 * sigma / R;
  const Within in = pressureWithin(r, std::max(R - 1.5 * h, 0.4 * R));
  const Vec3d centre = centreOf(r);
  const double extent = largest(
      r, [&](const World& x, std::size_t i) { return length(x.particles.position[i] - centre); });
  // Radius (m) of the ball with the particles' radius of gyration, each particle a cube. The drop must keep
  // its volume.
  const double spread = rootMeanSquare(
      r, [&](const World& x, std::size_t i) { return length(x.particles.position[i] - centre); });
  const double gyration = std::sqrt(5.0 / 3 * (spread * spread + 0.25 * w.scene.spacing * w.scene.spacing));
  const double speed = rootMeanSquare(
      r, [](const World& x, std::size_t i) { return length(x.particles.velocity[i]); });
  const auto inside = [&](const World& x, std::size_t i) {
    return length(x.particles.position[i] - centre) < R - 1.5 * h;
  };
  const double core = sum(r, [&](const World& x, std::size_t i) { return inside(x, i) ? 1.0 : 0.0; });
  const double relativeDensity = sum(r,
                                     [&](const World& x, std::size_t i) {
                                       return inside(x, i)
                                                  ? static_cast<double>(x.particles.relativeDensity[i])
                                                  : 0.0;
                                     }) /
                                 std::max(core, 1.0);
  // Viscosity is zero at rest and left out. Pairwise cohesion is in the pair forces, so their virial is the
  // pressure. The other forms of tension act at the surface only: the pressure inside is that of the
  // equation of state. Both virials are reported as well.
  const double mean = sum(r,
                          [&](const World& x, std::size_t i) {
                            return inside(x, i) ? static_cast<double>(pressureOfParticle(
                                                      x.scene, x.modules, x.particles, r.tools.liquids, i))
                                                : 0.0;
                          }) /
                      std::max(core, 1.0);
  const double jump = w.scene.numerics.tension == TensionForm::Pairwise ? in.pairs : mean;
  return {{"pressure jump", std::abs(jump / exact - 1), 0.05},
          {"pressure jump / exact", jump / exact},
          {"virial / exact", in.pairs / exact},
          {"all forces / exact", in.all / exact},
          {"radius", std::abs(gyration / R - 1), 0.01},
          {"radius / exact", gyration / R},
          {"extent / R", (extent + 0.5 * w.scene.spacing) / R},
          {"relative density inside", relativeDensity},
          {"speed / sqrt(sigma/(rho R))", speed / std::sqrt(sigma / (w.scene.materials[0].density * R))},
          {"mismatch of forces", in.mismatch / (sigma * w.scene.spacing)}};
}

/// Second mode: omega^2 = 8 sigma / (rho R^3), damped at 5 nu / R^2 (L32, art. 275 and 355).
struct SecondMode {
  double omega, damping, rest;  // rad/s, 1/s, s of damping before the mode starts
  explicit SecondMode(Trial& r) {
    const Material& m = r.world.scene.materials[0];
    const double R = radiusOf(r);
    omega = std::sqrt(8 * m.surfaceTension / (m.density * R * R * R));
    damping = 5 * m.viscosity.liquid / m.density / (R * R);
    rest = 0.3 * 2 * pi / omega;
  }
};

/// Damps the drop to rest, sets the velocities of the mode (a potential flow), and records the mode's
/// velocity moment.
void watchMode(Trial& r) {
  World& w = r.world;
  Continuum& p = w.particles;
  if (!r.notes.contains("radius")) {
    const SecondMode mode(r);
    r.notes = {{"radius", radiusOf(r)},
               {"omega", mode.omega},
               {"damping", mode.damping},
               {"rest", mode.rest},
               {"pushed", 0}};
  }
  const Vec3d centre = centreOf(r);
  if (r.notes["pushed"] == 0) {
    const bool push = w.clock.time >= r.notes["rest"];
    const double keep = std::exp(-4 * r.notes["omega"] * w.clock.stepDt), rate = 0.05 * r.notes["omega"];
    for (std::size_t i = 0; i < p.owned; i++) {
      const Vec3d x = p.position[i] - centre;
      p.velocity[i] = push ? Vec3d{-0.5 * x.x, -0.5 * x.y, x.z} * rate : p.velocity[i] * keep;
    }
    if (!push) return;
    r.notes["pushed"] = 1;
  }
  const double moment = sum(r, [&](const World& x, std::size_t i) {
    const Vec3d &at = x.particles.position[i], &v = x.particles.velocity[i];
    return x.particles.mass[i] *
           (2 * (at.z - centre.z) * v.z - (at.x - centre.x) * v.x - (at.y - centre.y) * v.y);
  });
  r.series.push_back({w.clock.time, {moment}});
}

std::vector<Figure> measureMode(Trial& r) {
  // Zeros of the velocity moment are half a period apart. The extremes between them give the damping.
  std::vector<double> zeros, peaks(1, 0.0);
  for (std::size_t k = 0; k + 1 < r.series.size(); k++) {
    const double a = r.series[k].value[0], b = r.series[k + 1].value[0];
    peaks.back() = std::max(peaks.back(), std::abs(a));
    if ((a > 0) == (b > 0)) continue;
    zeros.push_back(r.series[k].time + (r.series[k + 1].time - r.series[k].time) * a / (a - b));
    peaks.push_back(0);
  }
  if (zeros.size() < 3) return {{"zero crossings missing", 3 - static_cast<double>(zeros.size()), 0}};
  const double omega = r.notes["omega"], damping = r.notes["damping"];
  const double exact = 2 * pi / std::sqrt(omega * omega - damping * damping), period = zeros[2] - zeros[0];
  const double decay = 2 / period * std::log(peaks[1] / peaks[2]);
  return {{"period", std::abs(period / exact - 1), 0.05},
          {"period / exact", period / exact},
          {"damping / exact", decay / damping}};
}

}  // namespace

std::vector<Case> dropCases() {
  return {
      {"drop_laplace",
       "pressure in a drop at rest from all pair forces; 2 sigma / R",
       nullptr,
       {},
       {},
       {},
       measureLaplace},
      {"drop_oscillation",
       "second mode of a drop; omega^2 = 8 sigma / (rho R^3), damping 5 nu / R^2 (Lamb 1932)",
       nullptr,
       {},
       {},
       watchMode,
       measureMode},
  };
}

}  // namespace thaw::accuracy
