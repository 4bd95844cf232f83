#include "core/solid/plasticity.hpp"

#include "core/solid/laws/green.hpp"

namespace thaw {

Sym3d plasticFlow(const ElasticConstants& c, const Sym3d& strain, const Sym3d& plastic, double dt) {
  if (!(c.yield < never)) return plastic;
  Sym3d deviator = strain - plastic;
  const double mean = trace(deviator) / 3;
  deviator.xx -= mean;
  deviator.yy -= mean;
  deviator.zz -= mean;
  const double size = norm(deviator);
  if (!(size > c.yield)) return plastic;
  const double part = c.creep < never ? -std::expm1(-c.creep * dt) : 1;
  Sym3d next = plastic + (part * (size - c.yield) / size) * deviator;
  const double total = norm(next);
  if (total > c.maxPlastic) {
    // a plastic strain that was pushed forward may be above the limit already: it must not jump back
    const double limit = std::max(c.maxPlastic, norm(plastic));
    if (total > limit) next = (limit / total) * next;
  }
  return next;
}

double plasticLoss(const ElasticConstants& c, const Sym3d& strain, const Sym3d& before, const Sym3d& after) {
  // psi(before) - psi(after) = (after - before) : C : (strain - (before + after)/2)
  return doubleDot(hooke(after - before, c.lambda, c.mu), strain - 0.5 * (before + after));
}

Sym3d pushForward(const Mat3d& gradU, const Sym3d& plastic) {
  const Mat3d inverseF = inverse(identity3<double>() + gradU);
  const Sym3d elastic = greenStrain(gradU) - plastic;
  return -1.0 * symmetric(transpose(inverseF) * (full(elastic) * inverseF));
}

}  // namespace thaw
