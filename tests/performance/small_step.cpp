// SPDX-License-Identifier: Apache-2.0
// small_step fluid|heat|carried|elastic|mixed: a few steps of a small block on one rank without MPI.
// instructions_test.sh counts their instructions.
#include <cstdio>
#include <cstring>

#include "tests/support/simulation.hpp"

using namespace thaw;

namespace {

/// 4,096 particles with a free surface, slightly off the lattice by their motion.
Scene block(const char* what) {
  const double dx = 0.01, L = 16 * dx;
  Scene s = test::emptyScene(dx, {-L, -L, -L}, {2 * L, 2 * L, 2 * L});
  s.end = 1e9;
  s.numerics.elasticPrecision = Precision::Single;
  s.materials.emplace_back();
  Material& m = s.materials[0];
  m.name = "stuff";
  m.soundSpeed = 10;
  m.viscosity = {0.1, 0.1};
  m.artificialViscosity = 0.05;
  Body& b = test::addBox(s, {0, 0, 0}, {L, L, L});
  b.velocity = {1, 0.5, 0.3};
  b.spin = {0, 0, 3};
  if (std::strcmp(what, "fluid") == 0) return s;
  if (std::strcmp(what, "carried") == 0) {
    s.numerics.density = DensityForm::Continuity;
    return s;
  }
  m.conductivity = {1, 1};
  b.temperature = 335;
  b.temperatureGradient = {0, 0, 30 / L};
  if (std::strcmp(what, "heat") == 0) return s;
  m.young = {1e5, 0};
  if (std::strcmp(what, "elastic") == 0) {
    m.conductivity = {0, 0};
    b.temperature = 293.15;
    b.temperatureGradient = {};
    return s;
  }
  m.solidus = 330, m.liquidus = 340;
  m.latentHeat = 1e5;
  return s;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "small_step fluid|heat|carried|elastic|mixed\n"), 2;
  test::Simulation s(block(argv[1]));
  for (int k = 0; k < 4; k++)
    if (!s.step()) return 1;
  std::printf("%zu particles, %s\n", s.w.particles.owned, s.tools.sums.kernels->name);
  return 0;
}
