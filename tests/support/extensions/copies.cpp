// SPDX-License-Identifier: Apache-2.0
#include "tests/support/extensions/copies.hpp"

#include <cmath>
#include <memory>

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/geometry/shapes/primitives.hpp"
#include "core/math/exact_sum.hpp"
#include "tests/support/extensions/kernels.hpp"

namespace thaw::test {
namespace {

Extension copyOfLaw(const char* name, const LawKernels& kernels) {
  return {.name = name,
          .about = "Neo-Hookean",
          .keys = {{"unused", "", 1}},
          .law = {.kernels = kernels, .resistsInversion = true}};
}

void heatRegion(const OutsideLoad& load, const SignedDistance& shape, double power) {
  const Continuum& p = load.particles;
  const Bounds bounds = shape.bounds();
  std::vector<std::size_t> rows;
  ExactSum mass;
  for (std::size_t i = 0; i < p.owned; i++)
    if (nearBounds(bounds, p.position[i], 0) && shape.inside(p.position[i])) {
      rows.push_back(i);
      mass.add(p.mass[i]);
    }
  mass.carry();
  load.all.sum(mass.digit);
  const double total = mass.value();
  for (const std::size_t i : rows) load.heat[i] += power * (p.mass[i] / total);
}

}  // namespace

Extension copyOfTension() {
  return {.name = "copy_of_tension",
          .about = "pairwise surface tension",
          .keys = {{"tension", "N/m", 1, 0, 1e3, ""}},
          .pairForce = {.kernels = extensionKernels()->tension, .pack = [](const PairPacking& to) {
                          const double root = std::sqrt(to.settings.values.at("tension"));
                          for (std::size_t i = to.begin; i < to.end; i++)
                            to.values[i - to.begin].x = root * to.particles.mass[i] /
                                                        to.scene.materials[to.particles.material[i]].density;
                        }}};
}

Extension copyOfNeoHookean() { return copyOfLaw("copy", extensionKernels()->neoHookean); }
Extension singleCopyOfNeoHookean() { return copyOfLaw("single_copy", extensionKernels()->singleNeoHookean); }

Extension copyOfBall() {
  return {.name = "ball",
          .about = "a sphere",
          .keys = {{"size", "m", 0.1, 1e-9, 10, "radius"}},
          .shape = [](const ExtensionSettings& s) {
            return std::make_shared<SphereDistance>(s.values.at("size"));
          }};
}

Extension copyOfBuoyancy() {
  return {
      .name = "copy_of_buoyancy",
      .about = "buoyancy",
      .keys = {{"expansion", "1/K", 0, -0.1, 0.1, ""}, {"from", "K", 300, 0, 1e4, ""}},
      .load = [](const ExtensionSettings& s) -> OutsideSource {
        return [expansion = s.values.at("expansion"), from = s.values.at("from")](const OutsideLoad& load) {
          const Continuum& p = load.particles;
          const Vec3d gravity = load.run.scene.domain.gravity;
          for (std::size_t i = 0; i < p.owned; i++)
            if (p.phase[i] == Liquid)
              load.force[i] += gravity *
                               (-p.mass[i] * liquidFraction(p, i) * expansion * (p.temperature[i] - from));
        };
      }};
}

Extension copyOfRegion() {
  return {.name = "copy_of_region",
          .about = "a heated region",
          .keys = {{"power", "W", 1, 0, 1e9, ""}, {"size", "m", 1, 1e-9, 10, "radius"}},
          .load = [](const ExtensionSettings& s) -> OutsideSource {
            return [power = s.values.at("power"),
                    shape = std::make_shared<SphereDistance>(s.values.at("size"))](const OutsideLoad& load) {
              heatRegion(load, *shape, power);
            };
          },
          .heats = true};
}

}  // namespace thaw::test
