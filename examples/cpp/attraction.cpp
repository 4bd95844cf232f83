// SPDX-License-Identifier: Apache-2.0
// A force between particles of the program's own (attraction_isa.cpp): two liquids attract themselves and
// repel each other. Momentum and energy are conserved.
// attraction [FOLDER]: with a folder, it writes frames.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/math/exact_sum.hpp"
#include "core/simd/choose.hpp"
#include "core/terms/extensions.hpp"
#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"

namespace attraction {

THAW_CHOOSE(thaw::PairForceKernels, kernels, chooseKernels)

namespace {

/// Sets s = 1 for the first material of the scene, -1 for others.
void packSigns(const thaw::PairPacking& to) {
  for (std::size_t i = to.begin; i < to.end; i++)
    to.values[i - to.begin].x = to.particles.material[i] == 0 ? 1 : -1;
}

/// The force is k'' stiff: its step limit is that of a particle on a spring of 30 neighbours.
double stepLimit(const thaw::ExtensionSettings& settings, const thaw::Scene& scene) {
  const double h = scene.numerics.support * scene.spacing, dx = scene.spacing;
  double lightest = thaw::never;
  for (const thaw::Material& m : scene.materials) lightest = std::min(lightest, m.density * dx * dx * dx);
  const double stiffness = 30 * 6 * settings.values.at("strength") / (h * h);
  return stiffness > 0 ? 0.25 * std::sqrt(lightest / stiffness) : thaw::never;
}

thaw::Extension force() {
  return {
      .name = "attraction",
      .about = "liquids attract themselves and repel each other",
      .keys = {{"strength", "J", 1e-6, 0, 1, "energy of two coincident particles"}},
      .pairForce = {.kernels = *chooseKernels(""), .pack = packSigns, .stepLimit = stepLimit},
  };
}

constexpr const char* scene = R"(
spacing = "1 cm"
end = 0.1
[domain]
min = [-0.5, -0.5, -0.5]
max = [0.5, 0.5, 0.5]
gravity = [0, 0, 0]
[numerics]
density = "summation"
[material.oil]
density = 900
viscosity = "0.1 Pa s"
sound_speed = "4 m/s"
[material.water]
density = 1000
viscosity = "0.1 Pa s"
sound_speed = "4 m/s"
[[body]]
name = "left"
box = { size = [0.1, 0.1, 0.1] }
place = { move = [-0.05, 0, 0] }
material = "oil"
[[body]]
name = "right"
box = { size = [0.1, 0.1, 0.1] }
place = { move = [0.05, 0, 0] }
material = "water"
[extension.attraction]
strength = "0.02 mJ"
)";

struct State {
  double distance = 0;  // m, of the centres of both liquids along x
  double momentum = 0;  // kg m/s
  double radius = 0;    // m, of gyration of the first liquid
};

State stateOf(const thaw::Continuum& p) {
  double mass[2]{}, x[2]{}, square = 0;
  thaw::ExactSum momentum;
  for (std::size_t i = 0; i < p.owned; i++) {
    mass[p.material[i]] += p.mass[i];
    x[p.material[i]] += p.mass[i] * p.position[i].x;
    momentum.add(p.mass[i] * p.velocity[i].x);
  }
  const double middle = x[0] / mass[0];
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.material[i] == 0) {
      const thaw::Vec3d d = p.position[i] - thaw::Vec3d{middle, 0, 0};
      square += p.mass[i] * dot(d, d);
    }
  return {x[1] / mass[1] - middle, momentum.value(), std::sqrt(square / mass[0])};
}

}  // namespace
}  // namespace attraction

int main(int argc, char** argv) {
  thaw::MpiSession mpi(&argc, &argv);
  thaw::registerExtension(attraction::force());
  const std::string out = argc > 1 ? argv[1] : "";
  thaw::Simulation sim = thaw::Simulation::fromText(attraction::scene, {.scene = "attraction", .out = out},
                                                    MPI_COMM_SELF);
  const attraction::State start = attraction::stateOf(sim.particles());
  double fastest = 0;
  sim.run();
  sim.finish();
  const attraction::State end = attraction::stateOf(sim.particles());
  const thaw::Continuum& p = sim.particles();
  for (std::size_t i = 0; i < p.owned; i++) fastest = std::max(fastest, length(p.velocity[i]));
  const thaw::LedgerReport ledger = sim.ledger();
  const double residual = ledger.energyResidual / ledger.energyScale;
  std::printf(
      "distance %.5f -> %.5f m, radius %.5f -> %.5f m, fastest %.3g m/s, momentum %.1e, residual %.1e\n",
      start.distance, end.distance, start.radius, end.radius, fastest, end.momentum, residual);
  return end.distance > start.distance && std::abs(end.momentum) < 1e-12 && std::abs(residual) < 0.01 ? 0 : 1;
}
