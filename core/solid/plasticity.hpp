// Plastic flow by additive strain (O'Brien, Bargteil, Hodgins 2002, OBH02), with a rate that does not depend on the time step.
#pragma once
#include "core/math/mat3.hpp"
#include "core/solid/elastic_constants.hpp"

namespace thaw {

/// Frobenius norm.
inline double norm(const Sym3d& a) { return std::sqrt(doubleDot(a, a)); }

/// Plastic strain after dt (s): where the deviator of the elastic strain e = strain - plastic is longer than gamma_yield, its excess
/// decays as exp(-creep dt) (at once if creep is infinite), then |plastic| is cut at gamma_max (OBH02 eq. 3-6).
/// Two steps of dt/2 give the same as one of dt while the strain stays.
Sym3d plasticFlow(const ElasticConstants& c, const Sym3d& strain, const Sym3d& plastic, double dt);

/// Energy density lost when plastic strain goes from `before` to `after` at this strain, Pa; the same for every law (response.hpp).
double plasticLoss(const ElasticConstants& c, const Sym3d& strain, const Sym3d& before, const Sym3d& after);

/// Plastic strain in the frame of the deformed state, with which the elastic strain stays the same tensor and turns with the body:
/// -F^-T (strain - plastic) F^-1 (accuracy.md section 0, 6). det F > 0.
Sym3d pushForward(const Mat3d& gradU, const Sym3d& plastic);

}  // namespace thaw
