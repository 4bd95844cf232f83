// SPDX-License-Identifier: Apache-2.0
// Heat of moving sources against exact solutions (docs/theory/heat_sources.md).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {
namespace {

using std::numbers::pi;

/// A laser that moves along x over a block of one material.
struct Track {
  const Scene& s;
  const Material& m = s.materials[0];
  const Laser& laser = s.lasers[0];
  double power = m.absorptivity * laser.power;                                      // W, absorbed
  double diffusivity = m.conductivity.at(1) / (m.density * m.heatCapacity.at(1));   // m^2/s
  double speed = laser.motion.back().move.x / laser.motion.back().time;             // m/s
  Vec3d size = s.bodies[0].shape.size, centre = s.bodies[0].shape.move;             // m, block
  Vec3d beamAt(double t) const { return laser.position + Vec3d{speed * t, 0, 0}; }  // m

  /// Rise of the temperature (K) by a moving point source on a half-space (R46).
  double rosenthal(const Vec3d& x, double t) const {
    const Vec3d d = x - beamAt(t);
    const double r = length(d);
    return power / (2 * pi * m.conductivity.at(1) * r) * std::exp(-speed * (r + d.x) / (2 * diffusivity));
  }

  /// Gaussian of variance v about `from`, and its images at two insulating walls.
  static double images(double x, double from, double low, double high, double v) {
    const double period = 2 * (high - low);
    double sum = 0;
    for (int n = -2; n <= 2; n++)
      for (const double image : {from, 2 * low - from})
        sum += std::exp(-(x - image - n * period) * (x - image - n * period) / (2 * v));
    return sum / std::sqrt(2 * pi * v);
  }

  /// Rise (K) by a Gaussian source since time 0 (ET83), in a block with insulating faces. The
  /// integral over the age runs over its square root, which removes the singularity.
  double eagarTsai(const Vec3d& x, double t) const {
    const Vec3d low = centre - size * 0.5, high = centre + size * 0.5;
    const double beam = 0.25 * laser.radius * laser.radius;  // variance along an axis
    constexpr int points = 60;
    double sum = 0;
    for (int k = 0; k < points; k++) {
      const double root = std::sqrt(t) * (k + 0.5) / points, age = root * root, v = 2 * diffusivity * age;
      const Vec3d at = beamAt(t - age);
      sum += 2 * root * images(x.x, at.x, low.x, high.x, v + beam) *
             images(x.y, at.y, low.y, high.y, v + beam) * images(x.z, high.z, low.z, high.z, v);
    }
    return power / (m.density * m.heatCapacity.at(1)) * sum * std::sqrt(t) / points;
  }
};

using Exact = std::function<double(const Vec3d&)>;

/// Errors of the temperature rise in the part of the block where `within` holds. The first is L2 relative to
/// the exact rise, the second the largest one over `scale` (K).
std::vector<Figure> errorsOf(Trial& r, const Exact& exact, const std::function<bool(const Vec3d&)>& within,
                             double scale) {
  const double start = r.world.scene.bodies[0].temperature;
  const auto at = [&](const World& w, std::size_t i, auto value) {
    const Vec3d& x = w.particles.position[i];
    return within(x) ? value(w.particles.temperature[i] - start, exact(x)) : 0.0;
  };
  const double square = sum(r, [&](const World& w, std::size_t i) {
    return at(w, i, [](double rise, double e) { return (rise - e) * (rise - e); });
  });
  const double all = sum(
      r, [&](const World& w, std::size_t i) { return at(w, i, [](double, double e) { return e * e; }); });
  const double most = largest(r, [&](const World& w, std::size_t i) {
    return at(w, i, [](double rise, double e) { return std::abs(rise - e); });
  });
  return {{"L2(T)", std::sqrt(square / all), 0.02}, {"Linf(T)", most / scale, 0.02}};
}

/// Absorbed energy against absorptivity, power and time, and the unexplained heat.
void addBalance(Trial& r, std::vector<Figure>& figures) {
  const LedgerReport l = reportLedger(r.world, r.tools, r.all);
  const Track track{r.world.scene};
  figures.push_back(
      {"absorbed", std::abs(l.lasers.absorbed / (track.power * r.world.clock.time) - 1), 0.001});
  figures.push_back({"heat residual", std::abs(l.heatResidual) / l.lasers.absorbed, 1e-10});
}

std::vector<Figure> measureRosenthal(Trial& r) {
  const Track track{r.world.scene};
  const double t = r.world.clock.time, near = 2 * r.spacing();
  const Vec3d beam = track.beamAt(t);
  std::vector<Figure> figures = errorsOf(
      r, [&](const Vec3d& x) { return track.rosenthal(x, t); },
      [&](const Vec3d& x) { return length(x - beam) >= near && length(x - beam) <= 0.5; },
      track.rosenthal(beam - Vec3d{near, 0, 0}, t));
  addBalance(r, figures);
  return figures;
}

std::vector<Figure> measureEagarTsai(Trial& r) {
  const Track track{r.world.scene};
  const double t = r.world.clock.time;
  double peak = 0;
  for (double behind = 0; behind < 2 * track.laser.radius; behind += 0.05 * track.laser.radius)
    peak = std::max(peak, track.eagarTsai(track.beamAt(t) - Vec3d{behind, 0, 0}, t));
  std::vector<Figure> figures = errorsOf(
      r, [&](const Vec3d& x) { return track.eagarTsai(x, t); }, [](const Vec3d&) { return true; }, peak);
  addBalance(r, figures);
  return figures;
}

}  // namespace

std::vector<Case> sourceCases() {
  return {{.name = "rosenthal",
           .about = "moving point source on a block, outside of two spacings (R46)",
           .measure = measureRosenthal,
           .adapt = [](Scene& s) { s.lasers[0].radius = 0.5 * s.spacing; }},
          {.name = "eagar_tsai",
           .about = "moving Gaussian source on a block (ET83)",
           .measure = measureEagarTsai}};
}

}  // namespace thaw::accuracy
