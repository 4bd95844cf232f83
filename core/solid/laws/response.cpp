// SPDX-License-Identifier: Apache-2.0
#include "core/solid/laws/response.hpp"

#include <cmath>

#include "core/solid/laws/corotated.hpp"
#include "core/solid/laws/green.hpp"
#include "core/solid/laws/plasticity.hpp"
#include "core/solid/laws/volume.hpp"

namespace thaw {

ElasticResponse elasticResponse(const ElasticConstants& c, const Mat3d& gradU) {
  const Mat3d f = identity3<double>() + gradU;
  ElasticResponse r;
  if (c.law == ElasticLaw::Green) {
    const Sym3d strain = greenStrain(gradU);
    r = {greenEnergy(strain, c.lambda, c.mu), greenStress(f, strain, c.lambda, c.mu)};
  } else if (c.law == ElasticLaw::NeoHookean) {
    r = {neoHookeanEnergy(f, c.lambda, c.mu, std::log(neoHookeanLogged(f))),
         neoHookeanStress(f, c.lambda, c.mu)};
  } else if (c.law == ElasticLaw::Extension) {
    const LawResponse one = responseOf(*c.bound, gradU, c.lambda, c.mu);
    r = {one.energy, one.stress};
  } else {
    const Mat3d rotation = nearestRotation(f);
    r = {corotatedEnergy(f, rotation, c.lambda, c.mu), corotatedStress(f, rotation, c.lambda, c.mu)};
  }
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
  if (c.law == ElasticLaw::Green) return greenPrincipal(stretch, c.lambda, c.mu);
  if (c.law == ElasticLaw::NeoHookean) return neoHookeanPrincipal(stretch, c.lambda, c.mu);
  if (c.law == ElasticLaw::Extension) return principalOf(*c.bound, stretch, c.lambda, c.mu);
  return corotatedPrincipal(stretch, c.lambda, c.mu);
}

Sym3d cauchyStress(const Mat3d& piola, const Mat3d& gradU) {
  const Mat3d f = identity3<double>() + gradU;
  const double j = determinant(f);
  return j > 0 ? (1 / j) * symmetric(piola * transpose(f)) : Sym3d{};
}

}  // namespace thaw
