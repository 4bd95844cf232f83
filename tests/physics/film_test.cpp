// SPDX-License-Identifier: Apache-2.0
// A film of viscous liquid that flows down a gentle slope, against Nusselt's parabolic profile.
#include <gtest/gtest.h>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double spacing = 0.1, depth = 1, weight = 100, viscosity = 1;  // m, m, Pa/m, Pa s

/// The film on z = 0, periodic along x and y. Gravity is tilted.
Scene film(double slope, double end) {
  Scene s = columnScene(spacing, 0, 1.5 * depth);
  carryDensity(s, 0.07);
  s.numerics.viscosityCorrection = true;
  s.domain.gravity = {slope * weight, 0, -weight};
  s.materials[0].density = 1;
  s.materials[0].viscosity = {viscosity, viscosity};
  addBox(s, {0, 0, 0}, {6 * spacing, 6 * spacing, depth});
  s.end = end;
  return s;
}

/// Returns the ratio of the flow to that of the parabola u = slope weight (z H - z^2 / 2) / viscosity, by
/// least squares.
double flowOverExact(Simulation& r, double slope) {
  EXPECT_TRUE(r.run());
  const Continuum& p = r.particles();
  double own = 0, exact = 0;
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.phase[i] != Liquid) continue;
    const double z = p.position[i].z, u = slope * weight * (z * depth - 0.5 * z * z) / viscosity;
    own += p.velocity[i].x * u, exact += u * u;
  }
  return own / exact;
}

}  // namespace

// If the pressure of the offset layers beside the floor resisted shear, half of the flow would be lost.
TEST(FilmOnAFloor, FlowsDownTheGentlestSlope) {
  constexpr double slope = 0.001;
  Scene s = film(slope, 3);
  s.domain.side[2] = {Side::Wall, Side::Open};
  Simulation r(s);
  EXPECT_NEAR(flowOverExact(r, slope), 1, 0.06);
}

// The rock has no viscosity of its own.
TEST(FilmOnASolid, SticksToIt) {
  constexpr double slope = 0.05;
  for (const bool implicit : {false, true}) {
    SCOPED_TRACE(implicit);
    Scene s = film(slope, 2);
    if (implicit) s.numerics.viscositySolver = ViscositySolver::Implicit;
    s.domain.min.z = -2 * spacing;
    s.materials.emplace_back();
    s.materials[1].density = 1;
    s.materials[1].law.name = "rigid";
    Body& rock = addBox(s, {0, 0, -2 * spacing}, {6 * spacing, 6 * spacing, 0});
    rock.material = 1;
    rock.clamp.push_back(boxOf({-1, -1, -1}, {1, 1, 0}));
    Simulation r(s);
    EXPECT_NEAR(flowOverExact(r, slope), 1, 0.03);
  }
}

}  // namespace thaw::test
