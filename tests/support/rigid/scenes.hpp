// SPDX-License-Identifier: Apache-2.0
// Scenes of rigid solids.
#pragma once
#include "tests/support/simulation.hpp"

namespace thaw::test {

inline Material stone(double density = 2500) {
  Material m;
  m.name = "stone";
  m.density = density;
  m.law.name = "rigid";
  return m;
}

/// Wax whose solid is rigid; it melts from 313 to 338 K.
inline Material rigidWax() {
  Material m = wax();
  m.name = "wax";
  m.law.name = "rigid";
  m.young = m.poisson = {};
  m.damping = m.hourglass = 0;
  m.hysteresis = 0.3;
  return m;
}

/// A box of a rigid material in free space.
inline Scene freeBox(const Material& material, double spacing, const Vec3d& size) {
  Scene s = emptyScene(spacing, {-2, -2, -2}, {2, 2, 2});
  s.materials.push_back(material);
  addBox(s, -0.5 * size, 0.5 * size);
  return s;
}

/// Hot wax on a floor, with boxes of cold wax that fall into it: pieces melt and touch. After 0.03 s all
/// freezes.
inline Scene waxPieces() {
  Scene s = emptyScene(0.05, {-0.5, -0.5, -0.2}, {0.5, 0.5, 1});
  s.domain.gravity = {0, 0, -9.81};
  for (auto& side : s.domain.side) side = {Side::Wall, Side::Wall};
  s.materials.push_back(rigidWax());
  s.materials[0].conductivity = {2e4, 2e4};
  s.materials[0].viscosity = {5, 5};
  s.materials[0].soundSpeed = 40;
  addBox(s, {-0.5, -0.5, -0.2}, {0.5, 0.5, -0.05}).temperature = 420;
  addBox(s, {-0.35, -0.15, -0.05}, {0.35, 0.15, 0.05}).temperature = 327;
  addBox(s, {-0.1, -0.35, 0.05}, {0.1, 0.35, 0.2}).temperature = 305;
  Body& top = addBox(s, {0.15, 0.05, 0.1}, {0.35, 0.25, 0.25});
  top.temperature = 290;
  top.spin = {3, 1, 2};
  s.thermostats.emplace_back();
  s.thermostats[0].start = 0.03;
  s.thermostats[0].over = 0.01;
  s.thermostats[0].temperature = 300;
  return s;
}

}  // namespace thaw::test
