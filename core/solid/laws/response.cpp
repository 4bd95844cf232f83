#include "core/solid/laws/response.hpp"

#include <cmath>

#include "core/solid/laws/corotated.hpp"
#include "core/solid/laws/green.hpp"
#include "core/solid/laws/volume.hpp"

namespace thaw {

ElasticResponse elasticResponse(const ElasticConstants& c, const Mat3d& gradU, const Sym3d& plasticStrain) {
  const Mat3d f = identity3<double>() + gradU;
  const Sym3d strain = greenStrain(gradU);
  ElasticResponse r;
  if (c.law == ElasticLaw::Green) {
    const Sym3d elastic = strain - plasticStrain;
    r = {greenEnergy(elastic, c.lambda, c.mu), greenStress(f, elastic, c.lambda, c.mu)};
  } else {
    if (c.law == ElasticLaw::NeoHookean) {
      r = {neoHookeanEnergy(f, c.lambda, c.mu, std::log(neoHookeanLogged(f))), neoHookeanStress(f, c.lambda, c.mu)};
    } else {
      const Mat3d rotation = nearestRotation(f);
      r = {corotatedEnergy(f, rotation, c.lambda, c.mu), corotatedStress(f, rotation, c.lambda, c.mu)};
    }
    const Sym3d s = hooke(plasticStrain, c.lambda, c.mu);
    r.energy += doubleDot(s, 0.5 * plasticStrain - strain);
    r.stress = r.stress - times(f, s);
  }
  if (c.volume > 0) {
    r.energy += volumeEnergy(f, c.volume);
    r.stress = r.stress + volumeStress(f, c.volume);
  }
  return r;
}

Sym3d cauchyStress(const Mat3d& piola, const Mat3d& gradU) {
  const Mat3d f = identity3<double>() + gradU;
  const double j = determinant(f);
  return j > 0 ? (1 / j) * symmetric(piola * transpose(f)) : Sym3d{};
}

}  // namespace thaw
