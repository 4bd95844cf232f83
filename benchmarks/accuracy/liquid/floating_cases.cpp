// SPDX-License-Identifier: Apache-2.0
// Elastic bodies that float, sink or rise in water at rest. In each scene body 0 is the solid and body 1 the
// water.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {
namespace {

using std::numbers::pi;

double gravityOf(const Trial& r) { return -r.world.scene.domain.gravity.z; }
double waterDensity(const Trial& r) {
  return r.world.scene.materials[static_cast<std::size_t>(r.world.scene.bodies[1].material)].density;
}
double relativeDensity(const Trial& r) {
  return r.world.scene.materials[static_cast<std::size_t>(r.world.scene.bodies[0].material)].density /
         waterDensity(r);
}
double waterHeight(const Trial& r) { return r.world.scene.bodies[1].shape.size.z; }
double bodyMass(Trial& r, int body) {
  return sum(r, [body](const World& w, std::size_t i) {
    return w.particles.body[i] == body ? w.particles.mass[i] : 0;
  });
}

/// Relative density gained per metre of depth, g/c^2 (1/m).
double compressionRate(const Trial& r) {
  const double c = r.tools.liquids[static_cast<std::size_t>(r.world.scene.bodies[1].material)].soundSpeed;
  return gravityOf(r) / (c * c);
}

/// Starts the water compressed by its weight, so that no initial sound wave moves the body.
void compressWater(Trial& r) {
  Continuum& p = r.world.particles;
  const double rate = compressionRate(r), top = waterHeight(r);
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.body[i] != 1) continue;
    double& z = p.position[i].z;
    if (p.compression.active) p.compression[i] = rate * (top - z);
    z -= rate * (top * z - 0.5 * z * z);
  }
}

/// Records the mean height (m) of the solid's particles.
void watchHeight(Trial& r) {
  if (!r.notes.contains("mass")) r.notes["mass"] = bodyMass(r, 0);
  const double moment = sum(r, [](const World& w, std::size_t i) {
    return w.particles.body[i] == 0 ? w.particles.mass[i] * w.particles.position[i].z : 0;
  });
  r.series.push_back({r.world.clock.time, {moment / r.notes["mass"]}});
}

using Curve = std::vector<std::array<double, 2>>;  // time, value

Curve displacements(const Trial& r, double from) {
  Curve c;
  for (const Sample& s : r.series) c.push_back({s.time, s.value[0] - from});
  return c;
}

double valueAt(const Curve& c, double time) {
  for (std::size_t k = 1; k < c.size(); k++)
    if (c[k][0] >= time)
      return c[k - 1][1] + (c[k][1] - c[k - 1][1]) * (time - c[k - 1][0]) / (c[k][0] - c[k - 1][0]);
  return c.back()[1];
}

/// Time of the first change by `amount`; the last time if there is none.
double timeToChange(const Curve& c, double amount) {
  for (const auto& [time, value] : c)
    if (std::abs(value - c[0][1]) >= amount) return time;
  return c.back()[0];
}

double meanOf(const Curve& c, double from, double to) {
  constexpr int parts = 1000;
  double s = 0;
  for (int k = 0; k < parts; k++) s += valueAt(c, from + (k + 0.5) / parts * (to - from)) / parts;
  return s;
}

std::vector<double> crossings(const Curve& c, double level) {
  std::vector<double> times;
  for (std::size_t k = 1; k < c.size(); k++) {
    const double a = c[k - 1][1] - level, b = c[k][1] - level;
    if ((a > 0) != (b > 0)) times.push_back(c[k - 1][0] + (c[k][0] - c[k - 1][0]) * a / (a - b));
  }
  return times;
}

/// Mean over whole periods. The period is the first one between the first and third crossing of the mean (0
/// if there are fewer crossings).
struct Swing {
  double mean, period;
};
Swing swingOf(const Curve& c) {
  double level = meanOf(c, 0.5 * c.back()[0], c.back()[0]);
  for (int pass = 0; pass < 3; pass++)
    if (const std::vector<double> t = crossings(c, level); t.size() >= 3)
      level = meanOf(c, t[0], t[t.size() - 1 - (t.size() + 1) % 2]);
  const std::vector<double> t = crossings(c, level);
  return {level, t.size() >= 3 ? t[2] - t[0] : 0};
}

/// Adds residuals of the ledger: energy relative to the water's potential energy, momentum relative to m
/// sqrt(g L).
void addResiduals(Trial& r, double size, std::vector<Figure>& figures) {
  const LedgerReport ledger = reportLedger(r.world, r.tools, r.all);
  const double g = gravityOf(r);
  figures.push_back({"energy residual",
                     std::abs(ledger.energyResidual) / (0.5 * ledger.now.mass * g * waterHeight(r)), 0.01});
  figures.push_back(
      {"momentum residual", length(ledger.momentumResidual) / (ledger.now.mass * std::sqrt(g * size)), 1e-9});
}

// ---- floating ---------------------------------------------------------------------------------------------

/// x / x(0) of a floating cube in linear potential flow in the same tank. Reads a column of
/// references/floating_cube.csv; times in s.
Curve referenceHeave(int column, double unit) {
  const std::string path = std::string(THAW_BENCHMARK_FOLDER) + "/references/floating_cube.csv";
  FILE* in = std::fopen(path.c_str(), "r");
  if (!in) throw std::runtime_error(path + ": cannot be read; references/floating_cube.py writes it");
  Curve c;
  char line[256];
  double time, x[2];
  while (std::fgets(line, sizeof line, in))
    if (std::sscanf(line, "%lf,%lf,%lf", &time, &x[0], &x[1]) == 3) c.push_back({time * unit, x[column]});
  std::fclose(in);
  if (c.size() < 2) throw std::runtime_error(path + ": expected a table of three columns");
  return c;
}

/// Water and a cube of edge L. The level and the draught follow from the liquid volume over the tank's area,
/// V/A, and the height of the cube's bottom.
struct Float {
  double edge, share, waterLevel,
      draught;  // m; share: fraction of the tank's area that the cube takes; waterLevel: V/A
  explicit Float(Trial& r) {
    const Vec3d size = r.world.scene.domain.max - r.world.scene.domain.min;
    edge = r.world.scene.bodies[0].shape.size.z;
    share = edge * edge / (size.x * size.y);
    const double volume = bodyMass(r, 1) / waterDensity(r) * (1 - 0.5 * compressionRate(r) * waterHeight(r));
    waterLevel = volume / (size.x * size.y);
    draught = relativeDensity(r) * edge;
  }
  double centreAtRest() const { return waterLevel - draught * (1 - share) + 0.5 * edge; }
  double draughtAt(double centre) const { return (waterLevel - centre + 0.5 * edge) / (1 - share); }
};

std::vector<Figure> measureFloat(Trial& r, int column) {
  const Float f(r);
  const double rest = f.centreAtRest(), start = r.series[0].value[0] - rest;
  const Curve found = displacements(r, rest),
              exact = referenceHeave(column, std::sqrt(f.edge / gravityOf(r)));
  const double delay = timeToChange(found, 0.1 * r.spacing()),
               exactDelay = timeToChange(exact, 0.1 * r.spacing() / start);
  Curve cut;
  for (const auto& point : exact)
    if (point[0] <= found.back()[0]) cut.push_back(point);
  const Swing swing = swingOf(found), exactSwing = swingOf(cut);
  double squares = 0;
  for (const auto& [time, x] : found)
    squares += std::pow(x / start - valueAt(exact, time), 2) / static_cast<double>(found.size());
  const double draught = f.draughtAt(rest + swing.mean);
  std::vector<Figure> figures{{"draught", std::abs(draught / f.draught - 1), 0.02},
                              {"time to move", std::abs(delay / exactDelay - 1), 0.5},
                              {"heave period", std::abs(swing.period / exactSwing.period - 1), 0.1},
                              {"draught / exact", draught / f.draught},
                              {"time to move / exact", delay / exactDelay},
                              {"heave period / exact", swing.period / exactSwing.period},
                              {"heave period sqrt(g/L)", swing.period / std::sqrt(f.edge / gravityOf(r))},
                              {"RMS(heave) / start", std::sqrt(squares)}};
  addResiduals(r, f.edge, figures);
  return figures;
}

// ---- sinking and rising -----------------------------------------------------------------------------------

/// Displacement of a body released at rest under weight and buoyancy: (m + added mass) dv/dt = F - drag(v).
/// All terms are per displaced mass of water.
template<class Drag> Curve released(double density, double addedMass, double gravity, double end, Drag drag) {
  constexpr int steps = 20000;
  const double dt = end / steps;
  Curve c{{0, 0}};
  double x = 0, v = 0;
  const auto rate = [&](double speed) {
    return ((1 - density) * gravity - drag(speed)) / (density + addedMass);
  };
  for (int n = 1; n <= steps; n++) {
    const double middle = v + 0.5 * dt * rate(v);
    x += dt * middle;
    v += dt * rate(middle);
    c.push_back({n * dt, x});
  }
  return c;
}

std::vector<Figure> compareRelease(Trial& r, const Curve& exact, double size) {
  const Curve found = displacements(r, r.series[0].value[0]);
  const double delay = timeToChange(found, 0.1 * r.spacing()),
               exactDelay = timeToChange(exact, 0.1 * r.spacing());
  const double ratio = found.back()[1] / exact.back()[1], half = 0.5 * r.world.clock.time;
  std::vector<Figure> figures{{"way", std::abs(ratio - 1), 0.15},
                              {"time to move", std::abs(delay / exactDelay - 1), 0.5},
                              {"way / exact", ratio},
                              {"way at half the time / exact", valueAt(found, half) / valueAt(exact, half)},
                              {"time to move / exact", delay / exactDelay}};
  addResiduals(r, size, figures);
  return figures;
}

/// Added mass by potential flow in this tank (references/floating_cube.py). Drag of a cube at large Reynolds
/// numbers (H65).
std::vector<Figure> measureSinking(Trial& r) {
  constexpr double addedMass = 0.610, dragCoefficient = 1.05;
  const double edge = r.world.scene.bodies[0].shape.size.z;
  const auto drag = [&](double v) { return 0.5 * dragCoefficient * v * std::abs(v) / edge; };
  return compareRelease(r, released(relativeDensity(r), addedMass, gravityOf(r), r.world.clock.time, drag),
                        edge);
}

/// Added mass of a sphere in a large vessel: half the displaced mass. Drag of SN33, 0.44
/// above Re = 1000.
std::vector<Figure> measureRising(Trial& r) {
  const Scene& s = r.world.scene;
  const double radius = s.bodies[0].shape.radius,
               nu = s.materials[static_cast<std::size_t>(s.bodies[1].material)].viscosity.liquid /
                    waterDensity(r);
  const auto drag = [&](double v) {
    const double re = std::abs(v) * 2 * radius / nu;
    const double cd = re > 1000 ? 0.44 : re > 0 ? 24 / re * (1 + 0.15 * std::pow(re, 0.687)) : 0;
    return 0.5 * cd * v * std::abs(v) * pi * radius * radius / (4 * pi / 3 * radius * radius * radius);
  };
  return compareRelease(r, released(relativeDensity(r), 0.5, gravityOf(r), r.world.clock.time, drag),
                        2 * radius);
}

Case bodyCase(const char* name, const char* about, std::function<std::vector<Figure>(Trial&)> measure) {
  return {.name = name,
          .about = about,
          .place = compressWater,
          .watch = watchHeight,
          .measure = std::move(measure)};
}

}  // namespace

std::vector<Case> floatingCases() {
  return {
      bodyCase("floating_cube_50",
               "heave and draught of a cube of density 0.5; linear potential flow in the same tank",
               [](Trial& r) { return measureFloat(r, 0); }),
      bodyCase("floating_cube_90", "the same of density 0.9", [](Trial& r) { return measureFloat(r, 1); }),
      bodyCase("sinking_cube", "a cube of density 1.1 sinks from rest; weight, added mass and drag",
               measureSinking),
      bodyCase("rising_ball", "a ball of density 0.917 rises from rest; buoyancy, added mass and drag",
               measureRising)};
}

}  // namespace thaw::accuracy
