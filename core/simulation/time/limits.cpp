// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/time/limits.hpp"

#include <algorithm>
#include <cmath>

#include "core/fluid/flow_laws/particle_viscosity.hpp"
#include "core/kernels/lattice.hpp"
#include "core/materials/contact_modulus.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/materials/state_equation.hpp"
#include "core/materials/surface_tension.hpp"
#include "core/scene/material_use.hpp"
#include "core/scene/phase_density.hpp"
#include "core/solid/elasticity/elastic.hpp"

namespace thaw {

Limit StepLimits::smallest() const {
  return static_cast<Limit>(std::min_element(value.begin(), value.end()) - value.begin());
}

namespace {

/// Largest stiffness of liquids of these materials (Pa).
double stiffestLiquid(const Scene& s, const std::vector<LiquidMaterial>& liquids) {
  double stiffest = 0;
  for (std::size_t k = 0; k < s.materials.size(); k++)
    if (inUse(s, k) && canBeLiquid(s.materials[k])) stiffest = std::max(stiffest, liquids[k].stiffness);
  return stiffest;
}

/// Largest effective diffusivity (m^2/s) of a particle of material m. Next to a much better conductor the
/// harmonic mean is up to twice its own conductivity.
double largestDiffusivity(const Scene& s, const Material& m) {
  const HeatModel model = s.numerics.heat;
  double largest = 0;
  for (const double f : {0.0, 1.0}) {
    const double own = conductivityOf(model, m, f),
                 capacity = leastDensityOf(m) * heatCapacityOf(model, m, f);
    for (std::size_t k = 0; k < s.materials.size(); k++)
      for (const double g : {0.0, 1.0}) {
        const double other = inUse(s, k) ? conductivityOf(model, s.materials[k], g) : 0;
        if (own > 0 && other > 0) largest = std::max(largest, 2 * own * other / (own + other) / capacity);
      }
  }
  return largest;
}

/// Returns true if all particles of a material have one viscosity; others are evaluated per particle.
bool hasOneViscosity(const Material& m) { return m.viscosityTable.empty() && !hasFlowLaw(m); }

double largestViscosity(const Scene& s, const Material& m) {
  if (hasFlowLaw(m)) return largestFlowViscosity(s, m);
  if (m.viscosityTable.empty()) return std::max(m.viscosity.solid, m.viscosity.liquid);
  double largest = 0;
  for (const auto& point : m.viscosityTable) largest = std::max(largest, point.second);
  return largest;
}

/// Factor of the largest stable viscous step. Particles that are partly molten have viscous and elastic
/// forces, and are stable up to a shorter step.
double viscousFactor(const Numerics& n, const Modules& modules) {
  constexpr double besideElastic = 0.75;
  return n.cflViscous * (modules.elastic && modules.melting ? besideElastic : 1);
}

/// Returns the viscosity (Pa s) that limits the step of particles of material k with viscosity mu. Their
/// velocity change depends on their own mass alone (docs/validation/stability.md, row 12). Between liquids of
/// the pairwise form it is mu. Next to a thicker, nearly static liquid or a solid, the viscosity of a pair is
/// up to twice as large. However, the fastest wave among equal particles, with opposite motion of neighbours,
/// has the same rate (tests/stability: LightParticlesInAThickLiquid). For the same reason, the viscosity for
/// a solid is the largest one of the other liquids. Liquids with a table or a flow law are handled by
/// particleLimits. The arithmetic mean of the printed form has no such bound.
double viscosityOfStep(const Scene& s, std::size_t k, double mu) {
  const bool liquid = canBeLiquid(s.materials[k]), printed = s.numerics.viscosity == ViscosityForm::Laplacian;
  if (!printed && !s.materials[k].canBeSolid()) return mu;
  double pairs = liquid ? mu : 0;
  for (std::size_t j = 0; j < s.materials.size(); j++) {
    const Material& m = s.materials[j];
    if (j == k || !inUse(s, j) || !(canBeLiquid(m) || (liquid && printed))) continue;
    if (printed) pairs = std::max(pairs, 0.5 * (mu + largestViscosity(s, m)));
    else if (hasOneViscosity(m)) pairs = std::max(pairs, m.viscosity.liquid);
  }
  return pairs;
}

}  // namespace

StepLimits materialLimits(const Scene& s, const Modules& modules,
                          const std::vector<LiquidMaterial>& liquids) {
  const Numerics& n = s.numerics;
  StepLimits l;
  const double h = n.support * s.spacing;
  const auto take = [&](Limit which, double value) { l[which] = std::min(l[which], value); };
  const double stiffest = modules.fluid ? stiffestLiquid(s, liquids) : 0;
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    if (!inUse(s, k)) continue;
    const Material& m = s.materials[k];
    // A wider support does not soften the lattice, so supports beyond 2 spacings count as 2. A light
    // particle, liquid or solid, among particles of a stiffer liquid oscillates with the liquid's stiffness
    // and its own mass (docs/validation/stability.md, row 12).
    if (stiffest > 0 && !modules.incompressible) {
      const double own = canBeLiquid(m) ? liquids[k].soundSpeed : 0,
                   near = std::sqrt(stiffest / leastDensityOf(m));
      take(Limit::Sound, n.cflSound * std::min(h, 2 * s.spacing) / (near > own * (1 + 1e-12) ? near : own));
    }
    if (modules.fluid) {
      const bool constant = hasOneViscosity(m);
      const double artificial = artificialAtSurface(liquids[k], constant ? m.viscosity.liquid : 0);
      const bool printed = n.viscosity == ViscosityForm::Laplacian;
      const double mu = (modules.implicitViscosity || (printed && !constant)
                             ? 0
                             : viscosityOfStep(s, k, constant ? largestViscosity(s, m) : 0)) +
                        (canBeLiquid(m) ? 1.6 * artificial : 0);
      if (mu > 0)
        take(Limit::Viscous,
             viscousFactor(n, modules) * stableViscousStep(n) * h * h * leastDensityOf(m) / mu);
    }
    if (modules.fluid && canBeLiquid(m)) {
      // The surface energy is stiff if few particles interact. An inviscid drop gains 26 % of its energy in 6
      // s with a factor of 0.2. With 0.1, it gains 0.8 % in 3 s.
      const double stiff = modules.surfaceEnergy ? 0.12 : 1;
      if (m.surfaceTension > 0) take(Limit::Tension, stiff * n.cflTension * capillaryTime(s, m));
    }
    if (modules.heat) {
      const double diffusivity = largestDiffusivity(s, m);
      if (diffusivity > 0) take(Limit::Heat, n.cflHeat * stableHeatStep(n) * h * h / diffusivity);
    }
    if (modules.solid && m.canBeSolid())
      take(Limit::Contact, 0.5 * s.spacing * std::sqrt(solidDensityOf(m) / largestContactModulus(m)));
  }
  if (modules.solid) take(Limit::Elastic, elasticStepLimit(s));
  take(Limit::Scene, n.maxStep);
  return l;
}

double flowLawStepLimit(const Scene& s, const Material& m) {
  const double h = s.numerics.support * s.spacing;
  return s.numerics.cflViscous * stableViscousStep(s.numerics) * h * h * leastDensityOf(m) /
         (steepnessOf(m.flowLaw) * largestViscosity(s, m));
}

namespace {

/// Largest viscosity (Pa s) of owned particles of a material with a table or a flow law. It is a maximum over
/// particles and not pairs, since the pairs of a rank depend on the partition. A small change of the rate
/// changes the stress of a flow law by d stress / d rate, up to n times the viscosity.
double largestViscosityHere(const Continuum& p, const Scene& scene, std::size_t material) {
  const Material& m = scene.materials[material];
  double mu = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.material[i] == material && (p.phase[i] == Liquid || (p.liquid.active && p.liquid[i] > 0)))
      mu = std::max(mu, viscosityOfParticle(m, p, i, 1));
  return hasFlowLaw(m) ? steepnessOf(m.flowLaw) * mu : mu;
}

/// Smallest density (kg/m^3) of particles that material k drags along: its own, and those of solids.
double leastDensityNear(const Scene& s, std::size_t k) {
  double least = leastDensityOf(s.materials[k]);
  for (std::size_t j = 0; j < s.materials.size(); j++)
    if (inUse(s, j) && s.materials[j].canBeSolid()) least = std::min(least, leastDensityOf(s.materials[j]));
  return least;
}

}  // namespace

bool mayBeDry(const Scene& s, const Modules& modules) {
  return modules.substeps && modules.melting && s.emitters.empty();
}

bool isDry(const Continuum& p) {
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.phase[i] == Liquid || p.liquid[i] > 0) return false;
  return true;
}

LargestRates largestRates(const Continuum& p) {
  LargestRates largest;
  for (std::size_t i = 0; i < p.owned; i++) {
    largest.speed2 = std::max(largest.speed2, dot(p.velocity[i], p.velocity[i]));
    const Vec3d a = p.fastAcceleration.active && !(p.clamped.active && p.clamped[i])
                        ? p.acceleration[i] - p.fastAcceleration[i]
                        : p.acceleration[i];
    largest.acceleration2 = std::max(largest.acceleration2, dot(a, a));
  }
  return largest;
}

StepLimits particleLimits(const World& w, const LargestRates& largest, double stableViscousStep) {
  const Numerics& n = w.scene.numerics;
  StepLimits l;
  const double h = w.grid.support;
  if (largest.speed2 > 0) l[Limit::Speed] = supportsPerStep * h / std::sqrt(largest.speed2);
  if (largest.acceleration2 > 0) {
    // Incompressible liquid at rest falls in each half step and is stopped by the solver. With a factor of 1
    // it gains energy.
    constexpr double incompressible = 0.6;
    l[Limit::Acceleration] = (w.modules.incompressible ? incompressible : 1) * n.cflAcceleration *
                             std::sqrt(h / std::sqrt(largest.acceleration2));
  }
  for (std::size_t k = 0; k < w.scene.materials.size(); k++) {
    const Material& m = w.scene.materials[k];
    if (hasOneViscosity(m) || w.modules.implicitViscosity) continue;
    double mu = largestViscosityHere(w.particles, w.scene, k);
    if (mu > 0) mu = viscosityOfStep(w.scene, k, mu);
    if (mu > 0)
      l[Limit::Viscous] = std::min(l[Limit::Viscous], viscousFactor(n, w.modules) * stableViscousStep * h *
                                                          h * leastDensityNear(w.scene, k) / mu);
  }
  return l;
}

double soundStiffening(const Scene& scene, const Modules& modules, const Continuum& p) {
  if (scene.numerics.eos != EquationOfState::Tait || !modules.fluid || modules.incompressible) return 1;
  float most = 1;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.relativeDensity[i] > most && (p.phase[i] == Liquid || (p.liquid.active && p.liquid[i] > 0)))
      most = p.relativeDensity[i];
  return soundSpeedFactor(scene.numerics.eos, static_cast<double>(most));
}

double fastAccelerationLimit(const Scene& scene, const CellGrid& grid, const Continuum& p) {
  double hardest = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    hardest = std::max(hardest, dot(p.acceleration[i], p.acceleration[i]));
  return hardest > 0 ? scene.numerics.cflAcceleration * std::sqrt(grid.support / std::sqrt(hardest)) : never;
}

}  // namespace thaw
