// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/step/cases.hpp"

#include <cmath>
#include <numbers>

namespace thaw::bench {

Scene sceneOf(const Case& c, const std::string& ball) {
  Scene s;
  s.spacing = 0.01;
  s.numerics.support = c.support;
  s.numerics.bondSupport = c.support;
  s.numerics.precision = c.precision;
  s.numerics.elasticPrecision = c.elastic;
  s.numerics.selfContact = false;
  const double edge = std::round(std::cbrt(static_cast<double>(c.particles))), L = edge * s.spacing;
  s.domain.min = {-0.6 * L, -0.6 * L, -0.6 * L};
  s.domain.max = {1.9 * L, 1.9 * L, 1.9 * L};
  s.domain.gravity = {};
  s.output.every = 0;
  s.end = 1e9;
  s.numerics.fixedStep = 3e-6;  // short enough that the jittered block does not fly apart
  Material m;
  m.name = "stuff";
  m.soundSpeed = 10;
  m.viscosity = {0.1, 0.1};
  if (isElastic(c.kind)) m.young = {1e5, 0};
  if (c.kind == Kind::Heat || c.kind == Kind::Mixed) m.conductivity = {1, 1};
  Body b;
  b.name = "block";
  b.shape.size = {L, L, L};
  b.shape.move = {0.5 * L, 0.5 * L, 0.5 * L};
  b.velocity = {60, 40, 25};  // one particle in fifty changes its cell per step, as in a flow at a tenth of
                              // the speed of sound
  if (c.kind == Kind::Mesh) {
    b.shape.kind = ShapeKind::Mesh;
    b.shape.mesh = ball;
    b.shape.scale = std::cbrt(static_cast<double>(c.particles) * 3 / (4 * std::numbers::pi)) * s.spacing;
  }
  if (c.kind == Kind::Carried) {  // the default of scene files for liquids
    s.numerics.density = DensityForm::Continuity;
    s.numerics.tensileLimit = 1;
    s.numerics.shifting = 0.07;
  }
  if (c.kind == Kind::Heat) b.temperatureGradient = {1, 0, 0};
  if (c.kind == Kind::Mixed) {
    m.young = {1e5, 0};
    m.solidus = 330, m.liquidus = 340;
    m.latentHeat = 1e5;
    b.temperature = 335;
    b.temperatureGradient = {0, 0, 30 / L};
  }
  s.materials.push_back(m);
  s.bodies.push_back(b);
  return s;
}

Targets targetsOf(const Case& c, bool avx512) {
  const bool wide = c.support > support33 + 0.1, big = c.particles > 300000,
             real64 = c.precision == Precision::Double ||
                      (isElastic(c.kind) && c.elastic == Precision::Double);
  const double yard = wide ? 0.61 : 1.08;
  if (c.kind == Kind::Mixed || c.kind == Kind::Mesh || c.kind == Kind::Carried || (wide && real64)) return {};
  if (c.kind == Kind::Elastic) {
    if (real64) return {};
    return wide  ? Targets{4.2 / yard, 5.5 / yard}
           : big ? Targets{7 / yard, 9.3 / yard}
                 : Targets{9 / yard, 12 / yard};
  }
  if (wide) return {3.4 / yard, 4.5 / yard};
  if (real64) return {4.3 / yard, (big ? 5.25 : 5.9) / yard};
  if (!avx512) return {4.8 / yard, 6.3 / yard};
  return big ? Targets{5.5 / yard, 7.1 / yard} : Targets{6.0 / yard, 8.0 / yard};
}

std::vector<double> limitPhases(const Case& c) {
  if ((c.kind != Kind::Fluid && c.kind != Kind::Heat) || c.support > support33 + 0.1 ||
      c.precision == Precision::Double)
    return {};
  std::vector<double> all{10.5, 39, 20, 54};
  for (double& ns : all) ns *= 1.08e-3;
  return all;
}

}  // namespace thaw::bench
