// SPDX-License-Identifier: Apache-2.0
// extension_step PART built-in|extension: a few steps of a small block on one rank without MPI. The block
// uses a part of the library or its copy in an extension. extensions_test.sh compares their instructions.
#include <cstdio>
#include <cstring>
#include <string>

#include "tests/support/extensions/copies.hpp"
#include "tests/support/simulation.hpp"

using namespace thaw;

namespace {

constexpr double dx = 0.01, side = 16 * dx;

/// 4,096 particles with a free surface, slightly off the lattice by their motion.
Scene block() {
  Scene s = test::emptyScene(dx, {-side, -side, -side}, {2 * side, 2 * side, 2 * side});
  s.end = 1e9;
  s.materials.emplace_back();
  s.materials[0].name = "stuff";
  Body& b = test::addBox(s, {0, 0, 0}, {side, side, side});
  b.velocity = {1, 0.5, 0.3};
  b.spin = {0, 0, 3};
  return s;
}

Scene liquid() {
  Scene s = block();
  s.materials[0].soundSpeed = 10;
  s.materials[0].viscosity = {0.1, 0.1};
  return s;
}

Scene warmLiquid() {
  Scene s = liquid();
  s.materials[0].conductivity = {1, 1};
  s.bodies[0].temperature = 320;
  s.bodies[0].temperatureGradient = {0, 0, 30 / side};
  return s;
}

Scene withLaw(Precision precision, const char* law) {
  Scene s = block();
  s.numerics.elasticPrecision = precision;
  s.materials[0].young = {1e5, 1e5};
  s.materials[0].law.name = law;
  return s;
}

Scene withTension(bool extension) {
  Scene s = liquid();
  s.numerics.tension = TensionForm::Pairwise;
  s.numerics.density = DensityForm::Summation;
  if (extension) s.extensions.push_back({.name = "copy_of_tension", .values = {{"tension", 0.1}}});
  else s.materials[0].surfaceTension = 0.1;
  return s;
}

Scene withBuoyancy(bool extension) {
  Scene s = warmLiquid();
  s.domain.gravity = {0, 0, -9.81};
  if (extension) s.extensions.push_back({.name = "copy_of_buoyancy", .values = {{"expansion", 1e-3}}});
  else s.materials[0].expansion = 1e-3, s.materials[0].expansionFrom = 300;
  return s;
}

Scene withRegion(bool extension) {
  Scene s = warmLiquid();
  if (extension) {
    s.extensions.push_back({.name = "copy_of_region", .values = {{"power", 10}, {"size", side}}});
  } else {
    HeatedRegion& region = s.heatedRegions.emplace_back();
    region.name = "oven";
    region.shape.kind = ShapeKind::Sphere;
    region.shape.radius = side;
    region.power = 10;
  }
  return s;
}

Scene withObstacle(bool extension) {
  Scene s = liquid();
  Obstacle& o = s.obstacles.emplace_back();
  o.name = "ball";
  o.shape.kind = extension ? ShapeKind::Extension : ShapeKind::Sphere;
  o.shape.extension = {.name = "ball", .values = {{"size", 0.5 * side}}};
  o.shape.radius = 0.5 * side;
  o.shape.move = {1.5 * side, 0.5 * side, 0.5 * side};
  return s;
}

Scene sceneOf(const std::string& part, bool extension) {
  if (part == "law") return withLaw(Precision::Double, extension ? "copy" : "neo-hookean");
  if (part == "single_law") return withLaw(Precision::Single, extension ? "single_copy" : "neo-hookean");
  if (part == "pair_force") return withTension(extension);
  if (part == "force") return withBuoyancy(extension);
  if (part == "heat") return withRegion(extension);
  return withObstacle(extension);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3)
    return std::fprintf(stderr,
                        "extension_step law|single_law|pair_force|force|heat|shape "
                        "built-in|extension\n"),
           2;
  for (Extension e : {test::copyOfTension(), test::copyOfNeoHookean(), test::singleCopyOfNeoHookean(),
                      test::copyOfBall(), test::copyOfBuoyancy(), test::copyOfRegion()})
    registerExtension(std::move(e));
  Scene scene = sceneOf(argv[1], std::strcmp(argv[2], "extension") == 0);
  completeExtensions(scene);
  test::Simulation s(scene);
  for (int k = 0; k < 4; k++)
    if (!s.step()) return 1;
  std::printf("%zu particles, %s\n", s.w.particles.owned, s.tools.sums.kernels->name);
  return 0;
}
