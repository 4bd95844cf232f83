// SPDX-License-Identifier: Apache-2.0
// Contact angles and thermocapillary flow against exact solutions (docs/validation/accuracy.md).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks/accuracy/trial.hpp"
#include "core/materials/surface_tension.hpp"
#include "core/math/hash_random.hpp"

namespace thaw::accuracy {
namespace {

using std::numbers::pi;

constexpr double degree = pi / 180;

/// Volume of a spherical cap of radius of curvature 1 and contact angle a, and height of its centre of mass.
double capVolume(double a) {
  const double c = std::cos(a);
  return pi / 3 * (2 + c) * (1 - c) * (1 - c);
}
double capCentre(double a) {
  const double height = 1 - std::cos(a);
  const double top = 1 - 0.5 * height;
  return pi * height * height * top * top / capVolume(a) - (1 - height);
}

/// Contact angle (rad) of the cap whose centre of mass is at this height over the cubic root of its volume.
double angleOfHeight(double height) {
  double low = 1 * degree, high = 179.9 * degree;
  for (int k = 0; k < 60; k++) {
    const double a = 0.5 * (low + high);
    (capCentre(a) / std::cbrt(capVolume(a)) < height ? low : high) = a;
  }
  return 0.5 * (low + high);
}

/// Squared radius of the drop by height: in layers of one spacing, twice the mean square distance from the
/// axis. 0 in layers with few particles.
std::vector<double> squaredRadii(Trial& r, const Vec3d& centre) {
  const double dx = r.spacing();
  std::vector<double> squares;
  for (double z = 0.5 * dx; z < r.world.scene.domain.max.z; z += dx) {
    const auto within = [&](const World& w, std::size_t i) {
      return std::abs(w.particles.position[i].z - z) < 0.5 * dx;
    };
    const double count = sum(r, [&](const World& w, std::size_t i) { return within(w, i) ? 1.0 : 0.0; });
    const double square = sum(r, [&](const World& w, std::size_t i) {
      const Vec3d d = w.particles.position[i] - centre;
      return within(w, i) ? d.x * d.x + d.y * d.y : 0.0;
    });
    squares.push_back(count > 12 ? 2 * square / count : 0);
  }
  return squares;
}

/// Contact angle (rad) of the circle r^2 + z^2 = a + 2 b z that fits the profile best, b the height of its
/// centre.
double angleOfCircle(Trial& r, const Vec3d& centre) {
  const std::vector<double> squares = squaredRadii(r, centre);
  double n = 0, z1 = 0, z2 = 0, f1 = 0, fz = 0;
  for (std::size_t k = 1; k < squares.size(); k++) {  // the first layer has the foot of the drop
    const double z = (static_cast<double>(k) + 0.5) * r.spacing();
    if (!(squares[k] > 0)) continue;
    const double f = squares[k] + z * z;
    n += 1, z1 += z, z2 += z * z, f1 += f, fz += f * z;
  }
  const double b = 0.5 * (n * fz - z1 * f1) / (n * z2 - z1 * z1), a = (f1 - 2 * b * z1) / n;
  return std::acos(std::clamp(-b / std::sqrt(std::max(a + b * b, 1e-12)), -1.0, 1.0));
}

/// A drop's contact angle (degrees), from the height of its centre of mass and from a circle.
struct Angles {
  double byHeight, byCircle;
};
Angles anglesOf(Trial& r) {
  const double mass = sum(r, [](const World& w, std::size_t i) { return w.particles.mass[i]; });
  Vec3d centre;
  for (int a = 0; a < 3; a++)
    centre[a] = sum(r, [a](const World& w,
                           std::size_t i) { return w.particles.mass[i] * w.particles.position[i][a]; }) /
                mass;
  const double volume = mass / r.world.scene.materials[0].density;
  return {angleOfHeight(centre.z / std::cbrt(volume)) / degree, angleOfCircle(r, centre) / degree};
}

constexpr double restEnd = 0.4, shakingEnd = 0.8;  // fractions of the time of the run

/// Adds a random velocity to each particle; the mean velocity is removed. The strength falls to 0 from a rate
/// of energy of a particle's surface energy per capillary time.
void shake(Trial& r) {
  World& w = r.world;
  Continuum& p = w.particles;
  const Material& m = w.scene.materials[0];
  const double dx = w.scene.spacing,
               left = (shakingEnd - w.clock.time / w.clock.end) / (shakingEnd - restEnd),
               capillary = std::sqrt(m.density * dx * dx * dx / m.surfaceTension),
               kick = 4 * left * dx / capillary * std::sqrt(w.clock.stepDt / capillary);
  for (int a = 0; a < 3; a++) {
    const auto random = [&](std::size_t i) {
      const auto key = static_cast<std::uint64_t>(3 * w.clock.step + a);
      return kick * (randomUniform(w.scene.seed, Purpose::Separate, p.id[i], key) - 0.5);
    };
    const double mean = sum(r, [&](const World&, std::size_t i) { return random(i); }) /
                        sum(r, [](const World&, std::size_t) { return 1.0; });
    for (std::size_t i = 0; i < p.owned; i++) p.velocity[i][a] += random(i) - mean;
  }
}

/// Lets the drop come to rest twice. With a surface energy it is shaken in between. Surface particles resist
/// like a soft solid, and the drop stops short of its angle, as on a rough wall (DG96).
void watchDrop(Trial& r) {
  const Clock& c = r.world.clock;
  if (c.time < restEnd * c.end) return;
  if (!r.notes.contains("angle")) {
    const LedgerReport ledger = reportLedger(r.world, r.tools, r.all);
    r.notes["angle"] = anglesOf(r).byHeight;
    r.notes["residual"] = ledger.energyResidual;
  }
  const bool arrested = r.world.scene.numerics.tension == TensionForm::SurfaceEnergy;
  if (arrested && c.time < shakingEnd * c.end) shake(r);
}

std::vector<Figure> measureAngle(Trial& r) {
  const Material& m = r.world.scene.materials[0];
  const double exact = m.contactAngle / degree;
  const Angles is = anglesOf(r);
  const double speed = rootMeanSquare(
      r, [](const World& w, std::size_t i) { return length(w.particles.velocity[i]); });
  const double volume = sum(r, [](const World& w, std::size_t i) { return w.particles.mass[i]; }) / m.density;
  return {{"angle (deg)", std::abs(is.byHeight - exact), 5},
          {"angle of the circle (deg)", std::abs(is.byCircle - exact)},
          {"angle not shaken (deg)", std::abs(r.notes["angle"] - exact)},
          {"by height", is.byHeight},
          {"by circle", is.byCircle},
          {"not shaken", r.notes["angle"]},
          {"speed", speed},
          {"energy residual", std::abs(r.notes["residual"]) / (m.surfaceTension * std::cbrt(volume * volume)),
           0.01}};
}

std::function<void(Scene&)> atAngle(double degrees, double end) {
  return [=](Scene& s) {
    s.materials[0].contactAngle = degrees * degree;
    s.end = end;
  };
}

/// The layer of a scene: depth, stress along its surface, and the range in x where its flow is measured.
struct Layer {
  double depth, stress, viscosity, from, to;
  explicit Layer(Trial& r) {
    const Scene& s = r.world.scene;
    const Material& m = s.materials[0];
    const double length = s.domain.max.x - s.domain.min.x, width = s.domain.max.y - s.domain.min.y;
    depth = sum(r, [](const World& w, std::size_t i) { return w.particles.mass[i]; }) / m.density / length /
            width;
    stress = (surfaceTensionAt(m, *s.obstacles[1].temperature) -
              surfaceTensionAt(m, *s.obstacles[0].temperature)) /
             length;
    viscosity = m.viscosity.liquid;
    from = s.domain.min.x + 0.4 * length;
    to = s.domain.min.x + 0.6 * length;
  }
  /// Velocity (m/s) along x at a height (m) (B66).
  double exact(double height) const {
    const double z = height / depth;
    return stress * depth / viscosity * (0.75 * z * z - 0.5 * z);
  }
};

constexpr std::size_t sheets = 10;  // in the profile

/// Records sums of velocities and counts of particles by height.
void watchLayer(Trial& r) {
  constexpr std::int64_t every = 20;  // steps
  if (r.world.clock.step % every != 0 || r.world.clock.time < 0.7 * r.world.clock.end) return;
  const Layer layer(r);
  Sample sample{r.world.clock.time, {}};
  for (std::size_t k = 0; k < sheets; k++) {
    const auto within = [&](const World& w, std::size_t i) {
      const Vec3d& x = w.particles.position[i];
      return x.x > layer.from && x.x < layer.to &&
             static_cast<std::size_t>(std::clamp(x.z / layer.depth, 0.0, 0.999) * sheets) == k;
    };
    sample.value.push_back(sum(r, [&](const World& w, std::size_t i) { return within(w, i) ? 1.0 : 0.0; }));
    sample.value.push_back(sum(
        r, [&](const World& w, std::size_t i) { return within(w, i) ? w.particles.velocity[i].x : 0.0; }));
    sample.value.push_back(sum(r, [&](const World& w, std::size_t i) {
      return within(w, i) ? layer.exact(w.particles.position[i].z) : 0.0;
    }));
  }
  r.series.push_back(sample);
}

std::vector<Figure> measureLayer(Trial& r) {
  double count[sheets] = {}, is[sheets] = {}, exact[sheets] = {};
  for (const Sample& s : r.series)
    for (std::size_t k = 0; k < sheets; k++)
      count[k] += s.value[3 * k], is[k] += s.value[3 * k + 1], exact[k] += s.value[3 * k + 2];
  double off = 0, all = 0, product = 0;
  std::vector<Figure> profile;
  for (std::size_t k = 0; k < sheets; k++) {
    const double n = std::max(count[k], 1.0), u = is[k] / n, v = exact[k] / n;
    off += (u - v) * (u - v), all += v * v, product += u * v;
    profile.push_back({"u in sheet " + std::to_string(k), u});
    profile.push_back({"exact in sheet " + std::to_string(k), v});
  }
  const LedgerReport ledger = reportLedger(r.world, r.tools, r.all);
  std::vector<Figure> figures{
      {"L2(u)", std::sqrt(off / all), 0.03},
      {"strength / exact", product / all},
      {"momentum residual", length(ledger.momentumResidual) / ledger.now.mass, 1e-9},
      {"heat residual",
       std::abs(ledger.heatResidual) / (ledger.now.mass * r.world.scene.materials[0].heatCapacity.liquid),
       1e-10}};
  figures.insert(figures.end(), profile.begin(), profile.end());
  return figures;
}

}  // namespace

std::vector<Case> tensionCases() {
  std::vector<Case> cases;
  const auto drop = [&](const char* name, double degrees, double end) {
    cases.push_back({.name = name,
                     .about = "drop on a floor: contact angle of its cap (Young 1805)",
                     .scene = "contact_angle",
                     .watch = watchDrop,
                     .measure = measureAngle,
                     .adapt = atAngle(degrees, end)});
  };
  drop("contact_angle_30", 30, 10);
  drop("contact_angle_60", 60, 8);
  drop("contact_angle_90", 90, 8);
  drop("contact_angle_120", 120, 8);
  drop("contact_angle_150", 150, 8);
  cases.push_back({.name = "birikh",
                   .about = "thermocapillary return flow of a layer, against Birikh 1966",
                   .watch = watchLayer,
                   .measure = measureLayer,
                   .adapt = makeThin});
  return cases;
}

}  // namespace thaw::accuracy
