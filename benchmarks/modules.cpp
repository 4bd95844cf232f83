// SPDX-License-Identifier: Apache-2.0
// modules [--particles N] [--repeat R] [--csv FILE]: cost of each part of the model in time per particle and
// step, and in bytes per particle. Each scene runs with the part and without it. The two scenes take blocks
// of steps in turn, so that other load slows both. time_ratio is the median ratio of these blocks in
// processor time. The ns columns are medians of one run: compare rows by the ratio only. `idle_share` is the
// time that the scene without the module spends in its phases. Branches on absent modules inside other phases
// are not in it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>

#include "core/simulation/memory.hpp"
#include "tests/support/simulation.hpp"

namespace {

using namespace thaw;
using test::Simulation;

enum class Base { Liquid, Solid, Tank };
constexpr const char* baseNames[] = {"liquid", "solid", "tank"};

/// A block of one material at rest with a free surface; `edge` particles per side. Tank: liquid in gravity
/// between walls.
Scene block(int edge, Base base) {
  Scene s;
  s.spacing = 0.01;
  const double L = edge * s.spacing;
  s.domain.min = {-L, -L, -L};
  s.domain.max = {2 * L, 2 * L, 2 * L};
  s.domain.gravity = {};
  if (base == Base::Tank) {
    s.domain.min = {0, 0, 0};
    s.domain.max = {L, L, 2 * L};
    s.domain.side = {{{Side::Wall, Side::Wall}, {Side::Wall, Side::Wall}, {Side::Wall, Side::Wall}}};
    s.domain.gravity = {0, 0, -9.81};
  }
  s.output.every = 0;
  s.end = 1e9;
  s.materials.emplace_back();
  Material& m = s.materials[0];
  m.name = "stuff";
  m.soundSpeed = 10;
  m.viscosity = {0.1, 0.1};
  if (base == Base::Solid) m.young = {1e5, 0};
  test::addBox(s, {0, 0, 0}, {L, L, L});
  return s;
}

struct Row {
  const char* name;
  Base base;  ///< scene without the module
  std::function<void(Scene&)> add;
};

const std::vector<Row>& rows() {
  static const std::vector<Row> all{
      {"heat", Base::Liquid,
       [](Scene& s) {
         s.materials[0].conductivity = {1, 1}, s.bodies[0].temperatureGradient = {1, 0, 0};
       }},
      {"surface heat", Base::Liquid, [](Scene& s) { s.materials[0].convection = 10; }},
      {"surface tension", Base::Liquid, [](Scene& s) { s.materials[0].surfaceTension = 0.05; }},
      {"surface tension as an energy", Base::Liquid,
       [](Scene& s) {
         s.materials[0].surfaceTension = 0.05, s.numerics.tension = TensionForm::SurfaceEnergy;
       }},
      {"artificial viscosity", Base::Liquid, [](Scene& s) { s.materials[0].artificialViscosity = 0.1; }},
      {"velocity smoothing", Base::Liquid, [](Scene& s) { s.materials[0].xsph = 0.1; }},
      {"double precision", Base::Liquid, [](Scene& s) { s.numerics.precision = Precision::Double; }},
      {"melting with latent heat", Base::Liquid,
       [](Scene& s) {
         Material& m = s.materials[0];
         m.young = {1e5, 0};
         m.solidus = m.liquidus = 250;
         m.latentHeat = 1e5;
         m.conductivity = {1, 1};
         s.bodies[0].temperatureGradient = {1, 0, 0};
       }},
      {"heat of a solid", Base::Solid,
       [](Scene& s) {
         s.materials[0].conductivity = {1, 1}, s.bodies[0].temperatureGradient = {1, 0, 0};
       }},
      {"plastic flow", Base::Solid,
       [](Scene& s) {
         s.materials[0].yieldStrain = {0.1, 0.1};
       }},
      {"fracture", Base::Solid,
       [](Scene& s) { s.materials[0].breakStretch = 1.5, s.numerics.selfContact = false; }},
      {"fracture with contact of pieces", Base::Solid, [](Scene& s) { s.materials[0].breakStretch = 1.5; }},
      {"volume force", Base::Solid, [](Scene& s) { s.materials[0].volumeStiffness = 1e5; }},
      {"damping", Base::Solid, [](Scene& s) { s.materials[0].damping = 1; }},
      {"corotated law", Base::Solid, [](Scene& s) { s.materials[0].law.name = "corotated"; }},
      {"neo-hookean law", Base::Solid, [](Scene& s) { s.materials[0].law.name = "neo-hookean"; }},
      {"freezing and melting", Base::Solid,
       [](Scene& s) {
         Material& m = s.materials[0];
         m.solidus = m.liquidus = 350;
         m.latentHeat = 1e5;
         m.conductivity = {1, 1};
         s.bodies[0].temperatureGradient = {1, 0, 0};
       }},
      {"density by continuity", Base::Tank,
       [](Scene& s) { s.numerics.density = DensityForm::Continuity, s.numerics.correctedGradients = false; }},
      {"density by continuity, corrected gradients", Base::Tank,
       [](Scene& s) { s.numerics.density = DensityForm::Continuity; }},
      {"shifting", Base::Tank, [](Scene& s) { s.numerics.shifting = 0.1; }},
      {"incompressible pressure", Base::Tank,
       [](Scene& s) { s.numerics.solver = PressureSolver::Incompressible; }},
      {"implicit viscosity", Base::Tank,
       [](Scene& s) { s.numerics.viscositySolver = ViscositySolver::Implicit; }},
      {"an emitter before its start", Base::Tank,
       [](Scene& s) {
         Emitter e;
         e.name = "tap";
         e.radius = 4 * s.spacing;
         e.centre = {0.5 * s.domain.max.x, 0.5 * s.domain.max.y, 0.9 * s.domain.max.z};
         e.start = 1e8;
         s.emitters.push_back(e);
       }},
      {"4 substeps of the solid in a step", Base::Solid, [](Scene& s) { s.numerics.elasticSubsteps = 4; }},
  };
  return all;
}

double secondsOf(Simulation& s, int steps) {
  timespec start{}, end{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &start);
  for (int k = 0; k < steps; k++) s.step();
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &end);
  return static_cast<double>(end.tv_sec - start.tv_sec) +
         1e-9 * static_cast<double>(end.tv_nsec - start.tv_nsec);
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

/// Share of the time in phases of modules that the scene does not have.
double idleShare(const Simulation& s) {
  const PhaseTimes& t = s.tools.times;
  const Modules& m = s.w.modules;
  double idle = 0;
  if (!m.solid) idle += t[StepPhase::Elastic] + t[StepPhase::Bonds];
  if (!m.contact) idle += t[StepPhase::Contact];
  if (!m.heat) idle += t[StepPhase::Heat];
  if (!m.fluid) idle += t[StepPhase::Density];
  if (!m.neighbours) idle += t[StepPhase::Search] + t[StepPhase::Forces];
  return idle / t.total();
}

}  // namespace

int main(int argc, char** argv) {
  double particles = 27000;
  int repeat = 9;
  const char* csv = nullptr;
  for (int a = 1; a < argc; a += 2) {
    const std::string key = argv[a];
    if (a + 1 == argc)
      return std::fprintf(stderr, "scripts/bench modules [--particles 27000] [--repeat 9] [--csv FILE]\n"), 2;
    if (key == "--particles") particles = std::atof(argv[a + 1]);
    else if (key == "--repeat") repeat = std::atoi(argv[a + 1]);
    else if (key == "--csv") csv = argv[a + 1];
    else return std::fprintf(stderr, "unknown option %s\n", argv[a]), 2;
  }
  if (particles < 8 || repeat < 1)
    return std::fprintf(stderr, "modules: --particles must be at least 8, --repeat at least 1\n"), 2;
  FILE* out = csv ? std::fopen(csv, "w") : stdout;
  if (!out) return std::fprintf(stderr, "%s: cannot be written\n", csv), 3;
  std::fprintf(out,
               "case,base,particles,ns_without,ns_with,time_ratio,bytes_without,bytes_with,fields_without,"
               "fields_with,idle_share,target_idle_share,repeats\n");
  const int edge = static_cast<int>(std::lround(std::cbrt(particles))), steps = 5;
  for (const Row& row : rows()) {
    Simulation bare(block(edge, row.base));
    Scene scene = block(edge, row.base);
    row.add(scene);
    Simulation has(scene);
    const double n = static_cast<double>(bare.w.particles.owned);
    secondsOf(bare, steps), secondsOf(has, steps);
    bare.tools.times = {};
    std::vector<double> without, with, ratio;
    for (int r = 0; r < repeat; r++) {
      without.push_back(1e9 * secondsOf(bare, steps) / (steps * n));
      with.push_back(1e9 * secondsOf(has, steps) / (steps * n));
      ratio.push_back(with.back() / without.back());
    }
    std::fprintf(out, "\"%s\",%s,%.0f,%.1f,%.1f,%.3f,%.0f,%.0f,%zu,%zu,%.5f,0.01,%d\n", row.name,
                 baseNames[static_cast<int>(row.base)], n, median(without), median(with), median(ratio),
                 totalBytes(memoryOf(bare.w, bare.tools)) / n, totalBytes(memoryOf(has.w, has.tools)) / n,
                 fieldsOf(bare.w).size(), fieldsOf(has.w).size(), idleShare(bare), repeat);
    std::fflush(out);
  }
  if (csv) std::fclose(out);
  return 0;
}
