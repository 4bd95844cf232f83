// SPDX-License-Identifier: Apache-2.0
// Plastic flow under a strain prescribed for every particle.
#include "benchmarks/accuracy/solid/solid_trials.hpp"

#include "core/simulation/sums/solid_step.hpp"
#include "core/solid/laws/plasticity.hpp"
#include "core/solid/laws/response.hpp"

namespace thaw::accuracy {
namespace {

/// Draws the block along x at constant volume from one stretch to another in `dt` (s).
void draw(Trial& r, double from, double to, double dt) {
  Continuum& p = r.world.particles;
  const double along = to / from, across = 1 / std::sqrt(along);
  for (std::size_t i = 0; i < p.owned; i++)
    p.position[i] = {along * p.position[i].x, across * p.position[i].y, across * p.position[i].z};
  evaluate(r.world, r.halos(), r.tools, dt);
  findElasticEnergy(r.world.solids, r.world.bonds, r.tools.solid.elastic);  // also sets F
}

/// Norm of the deviator of the Cauchy stress, Pa.
double deviator(const World& w, std::size_t i) {
  const Mat3d elastic = elasticGradient(gradientOf(w, i), w.solids.plasticInverse[w.particles.solidIndex[i]]);
  Sym3d d = cauchyStress(elasticResponse(constantsOf(w), elastic).stress, elastic);
  const double mean = trace(d) / 3;
  d.xx -= mean, d.yy -= mean, d.zz -= mean;
  return norm(d);
}

double plasticNorm(const World& w, std::size_t i) {
  return norm(plasticStrain(w.solids.plasticInverse[w.particles.solidIndex[i]], {}));
}

void pull(Trial& r) {
  const Material& m = materialOf(r.world);
  const double plateau = 2 * constantsOf(r.world).mu * m.yieldStrain.solid;
  double worst = 0, excess = -never, stretch = 1;
  for (int n = 1; n <= 80; n++) {
    draw(r, stretch, 1 + 0.001 * n, 1e-3);
    stretch = 1 + 0.001 * n;
    const double plastic = largest(r, plasticNorm),
                 flows = -largest(r, [](const World&w, std::size_t i) { return -plasticNorm(w, i); });
    excess = std::max(excess, plastic - m.maxPlasticStrain);
    if (flows > 1e-6 && plastic < 0.99 * m.maxPlasticStrain)
      worst = std::max(worst, largest(r, [&](const World& w, std::size_t i) {
                         return std::abs(deviator(w, i) / plateau - 1);
                       }));
  }
  r.notes["plateau"] = worst;
  r.notes["excess"] = std::max(0.0, excess);
}

std::vector<Figure> measurePull(Trial& r) {
  return {{"sigma_eq/plateau - 1", r.notes["plateau"], 1e-12},
          {"|eps_p| beyond its limit", r.notes["excess"], 1e-12}};
}

/// Strains the block at once and holds it for 1/creep_rate in `steps` steps.
double elasticStrainAfterCreep(Trial& r, double stretch, int steps) {
  const double total = 1 / materialOf(r.world).creepRate.solid;
  Solids& s = r.world.solids;
  for (std::size_t k = 0; k < s.owned; k++) s.plasticInverse[k] = {};
  draw(r, 1, stretch, 0);
  const double first = largest(r, deviator);
  for (int n = 0; n < steps; n++) draw(r, 1, 1, total / steps);
  const double yield = 2 * constantsOf(r.world).mu * materialOf(r.world).yieldStrain.solid;
  const double exact = yield + (first - yield) * std::exp(-1.0),
               error = largest(
                   r, [&](const World&w, std::size_t i) { return std::abs(deviator(w, i) / exact - 1); });
  draw(r, stretch, 1, 0);
  return error;
}

void creep(Trial& r) {
  r.notes["coarse"] = elasticStrainAfterCreep(r, 1.02, 10);
  r.notes["fine"] = elasticStrainAfterCreep(r, 1.02, 100);
}

std::vector<Figure> measureCreep(Trial& r) {
  return {{"elastic strain at tau", r.notes["coarse"], 1e-12},
          {"elastic strain at tau with dt/10", r.notes["fine"], 1e-12}};
}

}  // namespace

std::vector<Case> plasticCases() {
  return {{"plasticity",
           "drawing at constant volume: sigma_eq = sqrt(3/2) 2 G gamma_yield, |ln Up| <= gamma_max (OBH02)",
           nullptr,
           {},
           pull,
           {},
           measurePull},
          {"creep",
           "strain held fixed: the stress decays as exp(-t/tau) towards the yield stress",
           nullptr,
           {},
           creep,
           {},
           measureCreep}};
}

}  // namespace thaw::accuracy
