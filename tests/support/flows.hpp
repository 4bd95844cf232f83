// SPDX-License-Identifier: Apache-2.0
// Scenes of liquids at walls with their exact solutions, shared by several physics tests.
#pragma once
#include <cmath>
#include <numbers>

#include "tests/support/simulation.hpp"

namespace thaw::test {

/// Flow between plates at z = 0 and z = height, started by gravity along x. SI units.
struct PlateFlow {
  double spacing = 0.1, height = 1, kinematicViscosity = 1, gravity = 0.8, end = 0.3;

  Scene scene() const {
    Scene s = columnScene(spacing, 0, height);
    s.domain.side[2] = {Side::Wall, Side::Wall};
    s.domain.gravity = {gravity, 0, 0};
    s.materials[0].soundSpeed = 2;
    s.materials[0].viscosity = {1000 * kinematicViscosity, 1000 * kinematicViscosity};
    addBox(s, {0, 0, 0}, {6 * spacing, 6 * spacing, height});
    s.end = end;
    return s;
  }
  /// Velocity (m/s) along x at height z at the end of the scene: the parabola minus the start-up series
  /// (Poiseuille flow, MFZ97).
  double exact(double z) const {
    const double nu = kinematicViscosity, H = height;
    double u = gravity / (2 * nu) * z * (H - z);
    for (int n = 1; n < 40; n += 2)
      u -= 4 * gravity * H * H / (nu * std::pow(std::numbers::pi * n, 3)) *
           std::sin(n * std::numbers::pi * z / H) *
           std::exp(-n * n * std::numbers::pi * std::numbers::pi * nu * end / (H * H));
    return u;
  }
  /// Root mean square error of the velocity, relative to the parabola's maximum.
  double error(const Continuum& p) const {
    const double fastest = gravity * height * height / (8 * kinematicViscosity);
    double square = 0;
    for (std::size_t i = 0; i < p.owned; i++)
      square += std::pow((p.velocity[i].x - exact(p.position[i].z)) / fastest, 2);
    return std::sqrt(square / static_cast<double>(p.owned));
  }
};

/// Liquid of one material (viscosity in Pa s) in the corner of a closed box, with gravity.
inline Scene liquidInABox(double spacing, const Vec3d& box, const Vec3d& liquid, float viscosity) {
  Scene s = emptyScene(spacing, {0, 0, 0}, box);
  for (auto& side : s.domain.side) side = {Side::Wall, Side::Wall};
  s.domain.gravity = {0, 0, -9.81};
  s.materials.emplace_back();
  s.materials[0].viscosity = {viscosity, viscosity};
  addBox(s, {0, 0, 0}, liquid);
  return s;
}

}  // namespace thaw::test
