// SPDX-License-Identifier: Apache-2.0
// Plastic flow at large strain. F = Fe Fp, and the elastic law acts only on Fe.
// A particle yields where its Cauchy stress sigma exceeds the yield stress: |dev sigma| > 2G y. The yield
// strain y is gamma_yield + h eps_p, with the equivalent plastic strain eps_p. The uniaxial yield stress is
// sqrt(6) G y.
// Flow scales the deviator e of the logarithmic elastic strain at fixed F: e <- r e with one r for all three
// principal axes. It thus conserves volume, is frame-independent, and ends where the stress of the law is on
// the yield surface. Small strains give the additive plastic strain of OBH02. Split and logarithmic return:
// S92.
#pragma once
#include "core/math/mat3.hpp"
#include "core/solid/laws/elastic_constants.hpp"

namespace thaw {

/// Frobenius norm.
inline double norm(const Sym3d& a) { return std::sqrt(doubleDot(a, a)); }

/// (1 + a)(1 + b) - 1: composition of two deformations (b first), without the rounding error of the
/// addition of 1.
inline Mat3d compose(const Mat3d& a, const Mat3d& b) { return a + b + a * b; }
/// Fe - 1, with plasticInverse = Fp^-1 - 1.
inline Mat3d elasticGradient(const Mat3d& gradU, const Mat3d& plasticInverse) {
  return compose(gradU, plasticInverse);
}

struct PlasticState {
  Mat3d inverse{};  ///< 1, Fp^-1 - 1
  double path = 0;  ///< 1, equivalent plastic strain: integral of sqrt(2/3) |d e|
};

struct PlasticFlow {
  PlasticState state;
  Mat3d elastic{};  ///< 1, Fe - 1
  double loss = 0;  ///< Pa, work of the flow as final stress times plastic strain, accurate if the stress
                    ///< hardly changes in a step
  bool flows = false;
};

/// Returns the flow at fixed F in a time dt (s). The excess |dev sigma|/2G - y decays as exp(-creep dt),
/// instantly if creep is infinite, so two steps of dt/2 equal one of dt. The norm of the total plastic strain
/// stays below gamma_max; only this limit uses referenceGradient. There is no flow if det Fe <= 0, or if flow
/// would gain energy. The latter happens under a pressure at which the law is unstable in shear. Green strain
/// at a Poisson's ratio of 0.3 is unstable below 0.67 of the volume.
PlasticFlow plasticFlow(const ElasticConstants& c, const Mat3d& gradU, const PlasticState& before,
                        const Mat3d& referenceGradient, double dt);

/// Deformation F and its plastic part.
struct PlasticDeformation {
  Mat3d gradU, plasticInverse;  ///< 1, F - 1 and Fp^-1 - 1
};
/// Returns the work (Pa) lost in a step from one deformation to another. The work is the mean of both
/// stresses times the change of F, like that of the step's forces. The change of the stored energy is
/// subtracted.
/// If plastic strain is at its limit, the stress changes by a multiple of the yield stress in a step.
/// PlasticFlow::loss is then not accurate.
double workOfFlow(const ElasticConstants& c, const PlasticDeformation& before,
                  const PlasticDeformation& after);

/// Returns ln Up of the total plastic deformation Fp F_ref = R Up, with F_ref = 1 + referenceGradient. It is
/// the logarithmic plastic strain along the axes of the first reference configuration.
Sym3d plasticStrain(const Mat3d& plasticInverse, const Mat3d& referenceGradient);

/// (Fp^-1 Fp^-T - 1)/2. For small strains it is minus the plastic strain since the last reference.
Sym3d plasticMetric(const Mat3d& plasticInverse);

/// Returns Fp^-1 - 1 after the present configuration becomes the reference, at the same stress: Ve - 1 of Fe
/// = Ve R.
Mat3d pushForward(const Mat3d& gradU, const Mat3d& plasticInverse);

}  // namespace thaw
