// SPDX-License-Identifier: Apache-2.0
// Plastic flow of whole bodies at large strain.
#include "benchmarks/accuracy/solid/solid_trials.hpp"
#include "core/domain/body_lattices.hpp"
#include "core/domain/emit.hpp"

#include "core/simulation/sums/solid_step.hpp"
#include "core/solid/laws/plasticity.hpp"
#include "core/solid/laws/response.hpp"

namespace thaw::accuracy {
namespace {

/// Uniaxial yield stress at rest, Pa: sqrt(3/2) 2 G gamma_yield.
double plateauOf(const World& w) {
  return std::sqrt(6.0) * constantsOf(w).mu * materialOf(w).yieldStrain.solid;
}

/// det Fe and Cauchy stress of a particle. Requires: findElasticEnergy was called.
struct State {
  double volume;
  Sym3d stress;
};
State stateOf(const World& w, std::size_t i) {
  const Mat3d elastic = elasticGradient(gradientOf(w, i), w.solids.plasticInverse[w.particles.solidIndex[i]]);
  return {determinant(identity3<double>() + elastic),
          cauchyStress(elasticResponse(constantsOf(w), elastic).stress, elastic)};
}

/// 1/det of the plastic part, minus 1.
double plasticVolume(const World& w, std::size_t i) {
  const std::uint32_t s = w.particles.solidIndex[i];
  const Mat3d one = identity3<double>();
  return 1 / determinant((one + w.solids.plasticInverse[s]) * inverse(one + w.solids.referenceGradient[s])) -
         1;
}
double largestPlasticVolume(Trial& r) {
  return largest(r, [](const World& w, std::size_t i) { return std::abs(plasticVolume(w, i)); });
}

double energyResidual(Trial& r) {
  findElasticEnergy(r.world.solids, r.world.bonds, r.tools.solid.elastic);
  const LedgerReport report = reportLedger(r.world, r.tools, r.all);
  return std::abs(report.energyResidual) / report.energyScale;
}

// ---- a block between plates -------------------------------------------------------------------------------

/// Compression at time t. The press moves 2.5 cm in 1 s and starts in contact.
double compression(double t) { return 0.025 * t / 0.08; }

void watchPress(Trial& r) {
  const Clock& c = r.world.clock;
  for (const auto& [note, at] : {std::pair{"3 %", 0.03}, {"9 %", 0.09}, {"30 %", 0.3}}) {
    if (r.notes.count(note) || compression(c.time) < at) continue;
    findElasticEnergy(r.world.solids, r.world.bonds, r.tools.solid.elastic);
    const double n = sum(r, [](const World&, std::size_t) { return 1.0; });
    r.notes[note] = -sum(r, [](const World& w, std::size_t i) { return stateOf(w, i).stress.zz; }) / n;
  }
}

std::vector<Figure> measurePress(Trial& r) {
  std::vector<Figure> f;
  for (const char* at : {"3 %", "9 %", "30 %"})
    f.push_back(
        {std::string("stress/plateau - 1 at ") + at, std::abs(r.notes[at] / plateauOf(r.world) - 1), 0.02});
  f.push_back({"volume of plastic flow", largestPlasticVolume(r), 1e-3});
  f.push_back({"energy residual", energyResidual(r), 0.02});
  return f;
}

// ---- slump test -------------------------------------------------------------------------------------------

/// Slump over height of a cylinder, tau' = tau_yield/(rho g H) (P96).
double pashias(double tau) { return 1 - 2 * tau * (1 - std::log(2 * tau)); }

/// Height (m) of the uppermost particles plus half a spacing.
double heightOf(Trial& r) {
  return largest(r, [](const World& w, std::size_t i) { return w.particles.position[i].z; }) +
         0.5 * r.spacing();
}

std::vector<Figure> measureSlump(Trial& r) {
  const World& w = r.world;
  const double height = w.scene.bodies[0].shape.height,
               shear = std::sqrt(2.0) * constantsOf(w).mu * materialOf(w).yieldStrain.solid;
  const double slump = 1 - heightOf(r) / height,
               expected = pashias(shear / (materialOf(w).density * length(w.scene.domain.gravity) * height));
  const double fastest = largest(
      r, [](const World& x, std::size_t i) { return length(x.particles.velocity[i]); });
  return {{"slump/Pashias - 1", std::abs(slump / expected - 1), 0.1},
          {"slump/height", slump},
          {"speed at the end/(slump/s)", fastest / (slump * height)},
          {"volume of plastic flow", largestPlasticVolume(r), 1e-3},
          {"energy residual", energyResidual(r), 0.02}};
}

void stiffer(Scene& s) { s.materials[0].yieldStrain = {0.0164, 0.0164}; }  // tau' = 0.2

// ---- Taylor's bar -----------------------------------------------------------------------------------------

/// Range of published finite element results (mm) at 80 us.
constexpr double lengths[2] = {21.4, 21.5}, radii[2] = {7.0, 7.2};
double outside(double x, const double (&range)[2]) {
  return std::max({0.0, range[0] / x - 1, x / range[1] - 1});
}

/// Largest radius (m) of the surface around the z axis. It is half a cell outside of the outermost particles,
/// and the cells are stretched as the particle's distance from the axis.
double surfaceRadius(Trial& r) {
  const Scene& s = r.world.scene;
  const Shapes shapes{makeSignedDistance(s.bodies[0].shape)};
  const SampleLattice lattice = bodyLattices(s, shapes)[0];
  return largest(r, [&](const World& w, std::size_t i) {
    const Continuum& p = w.particles;
    const Vec3d start = lattice.at(static_cast<std::int64_t>(numberOf(p.id[i])));
    return std::hypot(p.position[i].x, p.position[i].y) *
           (1 + 0.5 * lattice.cell.x / std::hypot(start.x, start.y));
  });
}

std::vector<Figure> measureBar(Trial& r) {
  const double lengthNow = 1e3 * heightOf(r), radius = 1e3 * surfaceRadius(r);
  return {{"length", outside(lengthNow, lengths), 0.02},
          {"mushroom radius", outside(radius, radii), 0.05},
          {"length (mm)", lengthNow},
          {"mushroom radius (mm)", radius},
          {"volume of plastic flow", largestPlasticVolume(r), 1e-3},
          {"energy residual", energyResidual(r), 0.02}};
}

}  // namespace

std::vector<Case> plasticFlowCases() {
  return {
      {"pressed_block",
       "a block between frictionless plates, to 30 %: sigma = sqrt(3/2) 2 G gamma_yield",
       nullptr,
       {},
       {},
       watchPress,
       measurePress},
      {"slump", "slump of a cylinder, tau' = 0.1: Pashias et al. 1996", nullptr, {}, {}, {}, measureSlump},
      {"slump_stiff",
       "slump of a cylinder, tau' = 0.2: Pashias et al. 1996",
       "slump",
       {},
       {},
       {},
       measureSlump,
       stiffer},
      {"taylor_bar",
       "copper rod on a wall at 227 m/s: length 21.4 to 21.5 mm, mushroom radius 7.0 to 7.2 mm at 80 us",
       nullptr,
       {},
       {},
       {},
       measureBar}};
}

}  // namespace thaw::accuracy
