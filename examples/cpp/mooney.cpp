// SPDX-License-Identifier: Apache-2.0
// An elastic law of the program's own (mooney_isa.cpp). Its stress is the derivative of its energy. A
// block that swings after a stretch keeps its energy.
// mooney [FOLDER]: with a folder, it writes frames.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/simd/choose.hpp"
#include "core/terms/extensions.hpp"
#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"

namespace mooney {

THAW_CHOOSE(thaw::LawKernels, kernels, chooseKernels)

namespace {

thaw::Extension law() {
  return {
      .name = "mooney",
      .about = "compressible Mooney-Rivlin material",
      .keys = {{"share", "", 0.2, 0, 1, "share of the second invariant in the shear modulus"}},
      .law = {.kernels = *chooseKernels(""),
              .stiffening = [](double stretch2, const thaw::LawValues&) { return stretch2 * stretch2; }},
  };
}

constexpr const char* scene = R"(
spacing = "5 cm"
end = 0.2
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
gravity = [0, 0, 0]
[numerics]
cfl_elastic = 0.2
[material.rubber]
density = 1000
young = "100 kPa"
poisson = 0.4
law = "mooney"
mooney = { share = 0.3 }
[[body]]
name = "block"
box = { size = [0.4, 0.4, 0.4] }
material = "rubber"
velocity = { x = "2 * x", y = "-y", z = "-z" }
[output]
every = 0.2
ledger_every = 0.002
)";

/// Largest difference of the stress from the derivative of the energy, over the largest stress.
double stressError(const thaw::BoundLaw& bound) {
  thaw::Mat3d g{};
  g.row[0] = {0.2, 0.1, -0.05}, g.row[1] = {0.03, -0.15, 0.2}, g.row[2] = {-0.1, 0.07, 0.1};
  const double lambda = 2e5, mu = 1e5, step = 1e-5;
  const thaw::Mat3d stress = thaw::responseOf(bound, g, lambda, mu).stress;
  double worst = 0, largest = 0;
  for (int r = 0; r < 3; r++)
    for (int c = 0; c < 3; c++) {
      thaw::Mat3d low = g, high = g;
      low.row[r][c] -= step, high.row[r][c] += step;
      const double slope = (thaw::responseOf(bound, high, lambda, mu).energy -
                            thaw::responseOf(bound, low, lambda, mu).energy) /
                           (2 * step);
      worst = std::max(worst, std::abs(slope - stress.row[r][c]));
      largest = std::max(largest, std::abs(stress.row[r][c]));
    }
  return worst / largest;
}

}  // namespace
}  // namespace mooney

int main(int argc, char** argv) {
  thaw::MpiSession mpi(&argc, &argv);
  thaw::registerExtension(mooney::law());
  const std::string out = argc > 1 ? argv[1] : "";
  thaw::Simulation sim = thaw::Simulation::fromText(mooney::scene, {.scene = "mooney", .out = out},
                                                    MPI_COMM_SELF);
  const double error = mooney::stressError(thaw::boundLaw(sim.scene().materials[0]));
  double most = 0;
  sim.onStep([&] { most = std::max(most, sim.ledger().now.elastic); });
  sim.run();
  sim.finish();
  const thaw::LedgerReport ledger = sim.ledger();
  const double residual = ledger.energyResidual / ledger.energyScale;
  std::printf("stress within %.1e of the energy's derivative; elastic energy up to %.3g J; residual %.1e\n",
              error, most, residual);
  return error < 1e-7 && most > 0.01 && std::abs(residual) < 5e-3 ? 0 : 1;
}
