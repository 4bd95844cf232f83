// SPDX-License-Identifier: Apache-2.0
#include "core/solid/laws/response.hpp"

#include "core/solid/laws/plasticity.hpp"
#include "core/solid/laws/volume.hpp"

namespace thaw {

ElasticResponse elasticResponse(const ElasticConstants& c, const Mat3d& gradU) {
  const Mat3d f = identity3<double>() + gradU;
  const LawResponse law = responseOf(*c.law, gradU, c.lambda, c.mu);
  ElasticResponse r{law.energy, law.stress};
  if (c.volume > 0) {
    r.energy += volumeEnergy(f, c.volume);
    r.stress = r.stress + volumeStress(f, c.volume);
  }
  return r;
}

ElasticResponse elasticResponse(const ElasticConstants& c, const Mat3d& gradU, const Mat3d& plasticInverse) {
  ElasticResponse r = elasticResponse(c, elasticGradient(gradU, plasticInverse));
  r.stress = r.stress + r.stress * transpose(plasticInverse);
  return r;
}

Vec3d principalKirchhoff(const ElasticConstants& c, const Vec3d& stretch) {
  return principalOf(*c.law, stretch, c.lambda, c.mu);
}

Sym3d cauchyStress(const Mat3d& piola, const Mat3d& gradU) {
  const Mat3d f = identity3<double>() + gradU;
  const double j = determinant(f);
  return j > 0 ? (1 / j) * symmetric(piola * transpose(f)) : Sym3d{};
}

}  // namespace thaw
