// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/scene/phase_density.hpp"
#include "core/solid/elasticity/elastic.hpp"
#include "core/solid/laws/plasticity.hpp"

namespace thaw {

namespace {

/// Upper bound of the largest stretch of Fp^-1, at least 1.
double plasticStretch(const Mat3d& plasticInverse) {
  const Sym3d m = plasticMetric(plasticInverse);
  const double mean = trace(m) / 3, square = doubleDot(m, m) - 3 * mean * mean;
  // No eigenvalue exceeds mean + sqrt(2/3) |deviator|.
  return std::sqrt(std::max(1.0, 1 + 2 * (mean + std::sqrt(2.0 / 3 * std::max(0.0, square)))));
}

/// Largest tangent modulus up to a squared stretch, relative to the modulus at rest.
double stiffeningOf(const ElasticConstants& c, double maxStretch2) {
  const ElasticLaw& law = *c.law->law;
  return law.stiffening ? std::max(1.0, law.stiffening(maxStretch2, c.law->values)) : 1;
}

double largestPlasticStrainBound(const ElasticWork& work, const Solids& solids) {
  double strainBound = 0;
  for (std::size_t s = 0; s < solids.owned; s++)
    strainBound = std::max(strainBound, work.strainBound[s] * plasticStretch(solids.plasticInverse[s]));
  return strainBound;
}

}  // namespace

double largestStrainBound(const ElasticWork& work, const Solids& solids) {
  if (work.plastic) return largestPlasticStrainBound(work, solids);
  double strainBound[8]{};  // eight independent chains, to hide the latency of comparisons
  const double* const of = work.strainBound.data();
  const std::size_t n = solids.owned;
  for (std::size_t s = 0; s + 8 <= n; s += 8)
    for (std::size_t k = 0; k < 8; k++) strainBound[k] = std::max(strainBound[k], of[s + k]);
  for (std::size_t s = n / 8 * 8; s < n; s++) strainBound[0] = std::max(strainBound[0], of[s]);
  return *std::max_element(strainBound, strainBound + 8);
}

std::int64_t countSingular(const ElasticWork& work, const Solids& solids) {
  std::int64_t count = 0;
  for (std::size_t s = 0; s < solids.owned; s++) count += work.rank[s] < 3;
  return count;
}

double elasticStepLimit(const Scene& scene, double maxStretch2, double strainBound) {
  double limit = never;
  const double distance = strainBound > 0 ? std::min(scene.spacing, latticeStrainBound / strainBound)
                                          : scene.spacing;
  for (const Material& m : scene.materials) {
    if (!m.canBeSolid()) continue;
    for (const double liquid : {0.0, 0.5, 1.0}) {
      const ElasticConstants c = elasticConstants(m, liquid);
      const double stiffening = stiffeningOf(c, maxStretch2);
      const double modulus = (c.lambda + 2 * c.mu) * stiffening + c.volume + 0.5 * c.hourglass;
      if (modulus > 0)
        limit = std::min(limit,
                         scene.numerics.cflElastic * distance * std::sqrt(solidDensityOf(m) / modulus));
      if (m.damping > 0) limit = std::min(limit, 0.25 / m.damping);
    }
  }
  return limit;
}

}  // namespace thaw
