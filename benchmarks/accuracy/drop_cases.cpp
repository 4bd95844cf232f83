// Surface tension against exact solutions (docs/validation/accuracy.md, fluid): Laplace's pressure and the
// second mode of a drop.
#include "benchmarks/accuracy/drop_cases.hpp"
#include "core/fluid/particle_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "core/fluid/cohesion.hpp"
#include "core/fluid/surface_kernel.hpp"
#include "core/kernels/kernels.hpp"
#include "core/time/integrate.hpp"

namespace thaw::accuracy {
namespace {

constexpr double pi = 3.14159265358979323846;

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

/// m, of the ball that the drop's mass fills at rest density.
double radiusOf(Trial& r) {
  return std::cbrt(3 * sum(r, massOf) / r.world.scene.materials[0].density / (4 * pi));
}

/// Share of the line from a to b that lies within a ball of radius R around the origin.
double shareWithin(const Vec3d& a, const Vec3d& b, double R) {
  const Vec3d d = b - a;
  const double A = dot(d, d), B = dot(a, d), C = dot(a, a) - R * R, root2 = B * B - A * C;
  if (root2 <= 0) return 0;
  const double root = std::sqrt(root2), from = std::max(0.0, (-B - root) / A),
               to = std::min(1.0, (-B + root) / A);
  return std::max(0.0, to - from);
}

/// The forces without viscosity between two liquid particles, as the sums have them (terms/forces.hpp,
/// terms/tension.hpp): N along i - j.
struct PairForce {
  const World& w;
  const StepTools& t;
  double term(std::size_t i) const {
    const double filling = static_cast<double>(w.particles.filling[i]);
    return static_cast<double>(pressureOfParticle(w, t.liquids, i)) / (filling * filling);
  }
  double operator()(std::size_t i, std::size_t j, double distance) const {
    const Continuum& p = w.particles;
    const Material& m = w.scene.materials[0];
    const double h = w.grid.support, q = distance / h, V = p.mass[i] / m.density / (h * h * h),
                 U = p.mass[j] / m.density / (h * h * h);
    const double slope = isa_base::WendlandC2::slope(q * q);
    const double pressure = -V * U * (term(i) + term(j)) * slope * t.perLatticeSum * q * h * h;
    if (w.scene.numerics.tension != TensionForm::Pairwise) return pressure;
    return pressure - isa_base::Cohesion::scale * V * U * m.surfaceTension * h * isa_base::Cohesion::force(q);
  }
};

/// Calls action(i, j, d, distance), d = x_i - x_j, for each owned particle and each neighbour, ghosts
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

/// N, the surface energy's force on i of the pair (terms/surface_energy.hpp), not along i - j alone; nothing
/// with other forms of tension.
Vec3d surfaceForce(const World& w, std::size_t i, std::size_t j, const Vec3d& d) {
  const Continuum& p = w.particles;
  if (!w.modules.surfaceEnergy) return {};
  const double h = w.grid.support, rho = w.scene.materials[0].density, q2 = dot(d, d) / (h * h);
  const Vec3d x = d / h, u = p.surfacePull[i] - p.surfacePull[j];
  const double slope = isa_base::SurfaceKernel::slope(q2), bend = isa_base::SurfaceKernel::bend(q2);
  const double along = bend * dot(u, x) + slope * (p.surfaceDraw[i] + p.surfaceDraw[j]);
  return (u * slope + x * along) * (-p.mass[i] / rho * (p.mass[j] / rho) / (h * h * h * h));
}

/// Pressures within a ball around the drop's centre: each pair's force times the share of its line that lies
/// in the ball, Irving and Kirkwood's pressure averaged over the ball (Cormier, Rickman & Delph 2001 eq. 13);
/// what moves adds its momentum flow. `pairs`: of pressure and of cohesion; `all`: of the surface's energy,
/// too, which pulls inside as well, where particles lie out of order. `mismatch`: how far all these forces
/// are from those of the program, root mean square.
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
  in.mismatch = rootMeanSquare(r,
                               [&](const World&, std::size_t i) { return length(forceOf(w, i) - force[i]); });
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
  // m, of the ball with the particles' radius of gyration, each of them a cube: the drop is to keep its
  // volume
  const double spread = rootMeanSquare(
      r, [&](const World& x, std::size_t i) { return length(x.particles.position[i] - centre); });
  const double gyration = std::sqrt(5.0 / 3 * (spread * spread + 0.25 * w.scene.spacing * w.scene.spacing));
  const double speed = rootMeanSquare(
      r, [](const World& x, std::size_t i) { return length(x.particles.velocity[i]); });
  const auto inside = [&](const World& x, std::size_t i) {
    return length(x.particles.position[i] - centre) < R - 1.5 * h;
  };
  const double core = sum(r, [&](const World& x, std::size_t i) { return inside(x, i) ? 1.0 : 0.0; });
  const double filling = sum(r,
                             [&](const World& x, std::size_t i) {
                               return inside(x, i) ? static_cast<double>(x.particles.filling[i]) : 0.0;
                             }) /
                         std::max(core, 1.0);
  // a particle's force from the sums: against sigma h, that of a few pairs; viscosity is left out, and is
  // nothing at rest cohesion is in the pairs: their virial is the pressure. Other forms act at the surface
  // alone, and the liquid inside has the pressure of its equation of state; the virial of the pressure's
  // pairs, and that of all forces, are printed beside it
  const double mean = sum(r,
                          [&](const World& x, std::size_t i) {
                            return inside(x, i)
                                       ? static_cast<double>(pressureOfParticle(x, r.tools.liquids, i))
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
          {"filling inside", filling},
          {"speed / sqrt(sigma/(rho R))", speed / std::sqrt(sigma / (w.scene.materials[0].density * R))},
          {"mismatch of forces", in.mismatch / (sigma * w.scene.spacing)}};
}

/// Second mode: omega^2 = 8 sigma / (rho R^3), damped at 5 nu / R^2 (Lamb 1932, art. 275 and 355).
struct SecondMode {
  double omega, damping, rest;  // rad/s, 1/s, s of coming to rest before it starts
  explicit SecondMode(Trial& r) {
    const Material& m = r.world.scene.materials[0];
    const double R = radiusOf(r);
    omega = std::sqrt(8 * m.surfaceTension / (m.density * R * R * R));
    damping = 5 * m.viscosity.liquid / m.density / (R * R);
    rest = 0.3 * 2 * pi / omega;
  }
};

/// First the drop is brought to rest: its velocities decay, as in a tougher liquid. Then it is pushed along
/// the mode (a potential flow), and the mode's velocity moment is noted.
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
  // crossings of zero of the velocity moment, half a period apart; its extremes in between give the damping
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
       "pressure in a drop at rest, of all pair forces; 2 sigma / R",
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
