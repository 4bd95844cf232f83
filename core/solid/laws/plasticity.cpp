// SPDX-License-Identifier: Apache-2.0
#include "core/solid/laws/plasticity.hpp"

#include <algorithm>

#include "core/math/sym_eigen.hpp"
#include "core/solid/laws/green.hpp"
#include "core/solid/laws/response.hpp"

namespace thaw {

namespace {

Sym3d deviator(Sym3d s) {
  const double mean = trace(s) / 3;
  s.xx -= mean, s.yy -= mean, s.zz -= mean;
  return s;
}

/// Path of elastic states whose deviator of the logarithmic strain is scaled by r: stretch_k = exp(mean + r
/// e_k).
struct RadialPath {
  const ElasticConstants& c;
  double mean = 0, e[3]{};  // ln of the stretches at r = 1: mean + e
  double size = 0;          // |e|
  double yield = 0;         // y at r = 1
  double scale = 0;         // 1/Pa, converts Kirchhoff stress to |dev sigma|/2G

  Vec3d stretch(double r) const {
    return {std::exp(mean + r * e[0]), std::exp(mean + r * e[1]), std::exp(mean + r * e[2])};
  }
  /// Deviator of the Kirchhoff stress, Pa.
  Vec3d stress(double r) const {
    const Vec3d t = principalKirchhoff(c, stretch(r));
    const double p = (t.x + t.y + t.z) / 3;
    return {t.x - p, t.y - p, t.z - p};
  }
  double hardening() const { return c.hardening * std::sqrt(2.0 / 3) * size; }
  /// |dev sigma|/2G - y.
  double excess(double r) const { return scale * length(stress(r)) - yield - (1 - r) * hardening(); }
};

/// Returns r in [0, high] at which the excess is `target`. Requires: the excess is below `target` at r = 0,
/// and is `most` > target at r = high.
double returnTo(const RadialPath& path, double target, double high, double most) {
  // Initial slope for linear growth of the stress.
  const double slope = (most + path.yield + (1 - high) * path.hardening()) / high + path.hardening();
  double low = 0, r0 = high, g0 = most - target, r = high - g0 / slope;
  for (int n = 0; n < 60; n++) {
    if (!(r > low && r < high)) r = 0.5 * (low + high);
    const double g = path.excess(r) - target;
    (g > 0 ? high : low) = r;
    const double change = n == 0 ? g / slope : g * (r - r0) / (g - g0);
    r0 = r, g0 = g;
    r -= change;
    if (!(std::abs(change) * path.size > 1e-11))
      break;  // the remaining error is the product of the last two changes
  }
  return r;
}

/// Returns true if the stress is certainly below the yield stress. This avoids the computation of
/// eigenvalues. The factor bounds |dev sigma|/2G over |dev E| for laws with boundsStress (test
/// Plasticity.SkippedGroupsAreBelowYield).
bool surelyBelow(const ElasticConstants& c, const Sym3d& strain, double yield) {
  const double size = norm(strain);
  return size < 0.1 && norm(deviator(strain)) * (c.mu + (8 * c.mu + 4 * c.lambda) * size) < yield * c.mu;
}

/// Limits the norm of the total plastic strain to gamma_max, or to its previous value if that is larger.
void limitPlasticStrain(const ElasticConstants& c, const Mat3d& gradU, const PlasticState& before,
                        const Mat3d& reference, PlasticFlow& flow) {
  const Sym3d first = plasticStrain(before.inverse, reference),
              now = plasticStrain(flow.state.inverse, reference);
  const double limit = std::max(c.maxPlastic, norm(first)), size = norm(now);
  if (!(size > limit)) return;
  const SymEigen e = eigenOf(now);
  double back[3];
  for (int k = 0; k < 3; k++) back[k] = std::expm1((1 - limit / size) * e.value[k]);
  const Mat3d one = identity3<double>(), f = one + reference;
  flow.state.inverse = compose(f * (full(withValues(e, back)) * inverse(f)), flow.state.inverse);
  flow.state.path = before.path +
                    std::sqrt(2.0 / 3) * norm(plasticStrain(flow.state.inverse, reference) - first);
  const Mat3d trial = elasticGradient(gradU, before.inverse);
  flow.elastic = elasticGradient(gradU, flow.state.inverse);
  flow.flows = elasticResponse(c, flow.elastic).energy < elasticResponse(c, trial).energy;
}

}  // namespace

PlasticFlow plasticFlow(const ElasticConstants& c, const Mat3d& gradU, const PlasticState& before,
                        const Mat3d& referenceGradient, double dt) {
  const PlasticFlow none{before, elasticGradient(gradU, before.inverse), 0, false};
  if (!(c.yield < never && c.mu > 0)) return none;
  const Sym3d strain = greenStrain(none.elastic);
  RadialPath path{c};
  path.yield = c.yield + c.hardening * before.path;
  if (c.law->law->boundsStress && surelyBelow(c, strain, path.yield)) return none;
  const SymEigen axes = eigenOf(strain);
  for (int k = 0; k < 3; k++) {
    if (!(axes.value[k] > -0.5)) return none;
    path.e[k] = 0.5 * std::log1p(2 * axes.value[k]);
  }
  path.mean = (path.e[0] + path.e[1] + path.e[2]) / 3;
  for (double& e : path.e) e -= path.mean;
  path.size = std::sqrt(path.e[0] * path.e[0] + path.e[1] * path.e[1] + path.e[2] * path.e[2]);
  if (!(path.size < never && determinant(identity3<double>() + none.elastic) > 0)) return none;

  path.scale = 1 / (2 * c.mu * std::exp(3 * path.mean));
  double high = 1, most = path.excess(1);
  // A law that weakens at large strain may have passed its yield stress.
  if (!(most > 0) && path.size > 1.5 * path.yield) {
    high = 1.5 * path.yield / path.size;
    most = path.excess(high);
  }
  const double target = most * (c.creep < never ? std::exp(-c.creep * dt) : 0);
  if (!(most > 0 && target < most)) return none;
  const double r = returnTo(path, target, high, most);
  const Vec3d s = path.stress(r);
  PlasticFlow flow{before, {}, (1 - r) * (s.x * path.e[0] + s.y * path.e[1] + s.z * path.e[2]), true};
  if (!(flow.loss > 0)) return none;
  double turn[3];
  for (int k = 0; k < 3; k++) turn[k] = std::expm1((r - 1) * path.e[k]);
  const Mat3d back = full(withValues(axes, turn));
  flow.state.inverse = compose(before.inverse, back);
  flow.state.path = before.path + std::sqrt(2.0 / 3) * (1 - r) * path.size;
  flow.elastic = elasticGradient(gradU, flow.state.inverse);  // gives the same bits as an evaluation without
                                                              // flow (repeatDeformation)
  if (c.maxPlastic < never) limitPlasticStrain(c, gradU, before, referenceGradient, flow);
  return flow.flows ? flow : none;
}

double workOfFlow(const ElasticConstants& c, const PlasticDeformation& before,
                  const PlasticDeformation& after) {
  const ElasticResponse from = elasticResponse(c, before.gradU, before.plasticInverse),
                        to = elasticResponse(c, after.gradU, after.plasticInverse);
  const Mat3d stress = from.stress + to.stress, change = after.gradU - before.gradU;
  double work = from.energy - to.energy;
  for (int k = 0; k < 3; k++) work += 0.5 * dot(stress.row[k], change.row[k]);
  return work;
}

Sym3d plasticStrain(const Mat3d& plasticInverse, const Mat3d& referenceGradient) {
  const Mat3d undone = plasticInverse * inverse(identity3<double>() + plasticInverse);  // 1 - Fp
  SymEigen e = eigenOf(greenStrain(compose(-1.0 * undone, referenceGradient)));
  for (double& v : e.value) v = 0.5 * std::log1p(2 * v);
  return withValues(e, e.value);
}

Sym3d plasticMetric(const Mat3d& plasticInverse) { return greenStrain(transpose(plasticInverse)); }

Mat3d pushForward(const Mat3d& gradU, const Mat3d& plasticInverse) {
  SymEigen e = eigenOf(greenStrain(transpose(elasticGradient(gradU, plasticInverse))));
  for (double& v : e.value) v = 2 * v / (1 + std::sqrt(1 + 2 * v));
  return full(withValues(e, e.value));
}

}  // namespace thaw
