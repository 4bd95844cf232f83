#include "core/time/limits.hpp"

#include <algorithm>
#include <cmath>

#include "core/solid/elastic.hpp"

namespace thaw {

Limit StepLimits::smallest() const {
  return static_cast<Limit>(std::min_element(value.begin(), value.end()) - value.begin());
}

namespace {

double largestViscosity(const Material& m) {
  double mu = m.viscosityTable.empty() ? std::max(m.viscosity.solid, m.viscosity.liquid) : 0;
  for (const auto& [T, value] : m.viscosityTable) mu = std::max(mu, value);
  return mu;
}

}  // namespace

StepLimits materialLimits(const Scene& s, const Modules& modules, const std::vector<LiquidMaterial>& liquids) {
  const Numerics& n = s.numerics;
  StepLimits l;
  const double h = n.support * s.spacing, h3 = h * h * h;
  const auto take = [&](Limit which, double value) { l[which] = std::min(l[which], value); };
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    const Material& m = s.materials[k];
    const bool liquid = !m.canBeSolid() || m.melts() || m.liquidAtStart;
    if (liquid) {
      take(Limit::Sound, n.cflSound * h / liquids[k].soundSpeed);
      const double mu = largestViscosity(m) + liquids[k].artificial;
      if (mu > 0 && m.viscosityTable.empty()) take(Limit::Viscous, n.cflViscous * h * h * m.density / mu);
      if (m.surfaceTension > 0) take(Limit::Tension, n.cflTension * std::sqrt(m.density * h3 / (2 * 3.14159265358979 * m.surfaceTension)));
    }
    if (modules.heat) {
      const double diffusivity = n.heat == HeatModel::Paper ? m.paperDiffusivity
                                                            : std::max(m.conductivity.solid / m.heatCapacity.solid, m.conductivity.liquid / m.heatCapacity.liquid) / m.density;
      if (diffusivity > 0) take(Limit::Heat, n.cflHeat * h * h / diffusivity);
    }
    if (m.canBeSolid()) take(Limit::Contact, 0.5 * s.spacing * std::sqrt(m.density / m.young.solid));
  }
  if (modules.solid) take(Limit::Elastic, elasticStepLimit(s));
  take(Limit::Scene, n.maxStep);
  return l;
}

StepLimits particleLimits(const World& w) {
  const Continuum& p = w.particles;
  const Numerics& n = w.scene.numerics;
  StepLimits l;
  double fastest = 0, hardest = 0;
  for (std::size_t i = 0; i < p.owned; i++) {
    fastest = std::max(fastest, dot(p.velocity[i], p.velocity[i]));
    hardest = std::max(hardest, dot(p.acceleration[i], p.acceleration[i]));
  }
  const double h = w.grid.support;
  if (fastest > 0) l[Limit::Speed] = 0.25 * h / std::sqrt(fastest);  // nobody passes through a particle, or a cell, in a step
  if (hardest > 0) l[Limit::Acceleration] = n.cflAcceleration * std::sqrt(h / std::sqrt(hardest));
  for (std::size_t k = 0; k < w.scene.materials.size(); k++) {
    const Material& m = w.scene.materials[k];
    if (m.viscosityTable.empty()) continue;
    double coldest = never;
    for (std::size_t i = 0; i < p.owned; i++)
      if (p.material[i] == k && p.phase[i] == Liquid) coldest = std::min(coldest, p.temperature.active ? p.temperature[i] : 0.0);
    if (coldest < never) l[Limit::Viscous] = std::min(l[Limit::Viscous], n.cflViscous * h * h * m.density / viscosityAt(m, 1, coldest));
  }
  return l;
}

namespace {

/// The next time that must be hit.
double target(const Clock& c) {
  const double frame = c.every > 0 ? static_cast<double>(c.frame) * c.every : never;
  return std::min(c.end, frame > c.time ? frame : never);
}

}  // namespace

double clip(const Clock& c, double dt) {
  const double left = target(c) - c.time;
  if (!(left > 0)) return dt;
  if (dt >= left * (1 - 1e-9)) return left;
  if (2 * dt > left) return 0.5 * left;
  return dt;
}

double timeAfter(const Clock& c, double dt) {
  const double t = target(c);
  return c.time + dt >= t || t - (c.time + dt) < 1e-9 * dt ? t : c.time + dt;
}

}  // namespace thaw
