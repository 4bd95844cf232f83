// SPDX-License-Identifier: Apache-2.0
// Stress and energy of eight solids, by laws that are inlined into the bond loops and by calls of other laws.
// Only code that is compiled per instruction set includes this.
// `Laws` has
//   template<class F> static bool at(const ElasticLaw&, F&& f);
// which calls f.template operator()<Law>() of a law that is inlined, and returns false for others.
#pragma once
#include <type_traits>

#include "core/solid/elasticity/elastic_lanes.hpp"
#include "core/solid/laws/law_point.hpp"

namespace thaw {
namespace THAW_ISA {

/// Natural logarithm of each lane, by the math library that all instruction sets share.
THAW_INLINE LanesD logarithm(LanesD a) {
  alignas(64) double values[8];
  toDoubles(a, values);
  takeLogarithmsOfLanes(values);
  return loadRow(values);
}

template<class T> THAW_INLINE Mat3<T> addIdentity(Mat3<T> f) {
  f.row[0].x += T(1.0);
  f.row[1].y += T(1.0);
  f.row[2].z += T(1.0);
  return f;
}
template<class Real> THAW_INLINE Mat3<Lanes<Real>> narrowed(const Mat3<LanesD>& m) {
  Mat3<Lanes<Real>> out;
  for (int r = 0; r < 3; r++) {
    narrow(m.row[r].x, out.row[r].x);
    narrow(m.row[r].y, out.row[r].y);
    narrow(m.row[r].z, out.row[r].z);
  }
  return out;
}
template<class Real> THAW_INLINE Mat3<Lanes<Real>> narrowed(const Mat3<LanesF>& m) { return m; }

/// The elastic deformation of a group, in the precision of the bonds.
template<class Real> struct GroupDeformation {
  const double *lambda, *mu;             ///< Pa, by lane
  const Mat3<Lanes<Real>>&gradient, &f;  ///< F - 1, F
  bool computeEnergy;
  template<class T> THAW_INLINE LawPoint<T> pointOf(const LawValues& values) const {
    if constexpr (std::is_same_v<T, Lanes<Real>>) {
      return {f, fromDoubles<Real>(lambda), fromDoubles<Real>(mu), values, gradient};
    } else {
      const Mat3<T> wide = widened(gradient);
      return {addIdentity(wide), loadRow(lambda), loadRow(mu), values, wide};
    }
  }
};

/// Sets stress (Pa, first Piola) and, if wanted, energy density (Pa) of all lanes by one law.
/// Returns the lanes that have softened (LawDefaults).
template<class Law, class Real>
THAW_INLINE unsigned respondInline(const GroupDeformation<Real>& g, const LawValues& values,
                                   Mat3<Lanes<Real>>& stress, double energy[8]) {
  using Stress = std::conditional_t<stressInDouble<Law>(), LanesD, Lanes<Real>>;
  using Energy = std::conditional_t<energyInDouble<Law>(), LanesD, Lanes<Real>>;
  const LawPoint<Stress> at = g.template pointOf<Stress>(values);
  const auto shared = sharedOf<Law>(at);
  stress = narrowed<Real>(stressOf<Law>(at, shared));
  if (g.computeEnergy) {
    if constexpr (std::is_same_v<Stress, Energy>) {
      toDoubles(widen(energyOf<Law>(at, shared)), energy);
    } else {
      const LawPoint<Energy> there = g.template pointOf<Energy>(values);
      toDoubles(widen(energyOf<Law>(there, sharedOf<Law>(there))), energy);
    }
  }
  if constexpr (requires { Law::softened(at, shared); }) return Law::softened(at, shared);
  else return 0;
}

/// The same with a law that may be inlined.
template<class Laws, class Real>
THAW_INLINE unsigned respondBy(const BoundLaw& law, const GroupDeformation<Real>& g,
                               Mat3<Lanes<Real>>& stress, double energy[8]) {
  unsigned softened = 0;
  const auto inlined = [&]<class Law>() __attribute__((always_inline)) {
    softened = respondInline<Law>(g, law.values, stress, energy);
  };
  if (Laws::at(*law.law, inlined)) return softened;
  alignas(64) double gradient[9][8], piola[9][8];
  storeMatrix<Real>(g.gradient, gradient);
  respondGroup(*law.law, {gradient, g.lambda, g.mu, law.values, piola, g.computeEnergy ? energy : nullptr,
                          sizeof(Real) == 4});
  stress = loadMatrix<Real>(piola);
  return 0;
}

/// The same for a group of several laws. Such groups are rare, so a separate function keeps the loop over
/// groups short.
template<class Laws, class Real>
__attribute__((noinline, flatten)) unsigned respondMixed(const LaneConstants& c,
                                                         const GroupDeformation<Real>& g,
                                                         Mat3<Lanes<Real>>& stress, double energy[8]) {
  unsigned softened = 0;
  for (int k = 0; k < c.laws; k++) {
    Mat3<Lanes<Real>> one{};
    alignas(64) double psi[8]{}, ours[8];
    softened |= respondBy<Laws>(*c.law[k], g, one, psi) & c.lanesOf[k];
    for (int l = 0; l < 8; l++) ours[l] = c.lanesOf[k] >> l & 1;
    const auto mask = Lanes<Real>(Real(0.5)) < fromDoubles<Real>(ours);
    for (int r = 0; r < 3; r++)
      stress.row[r] = {select(mask, one.row[r].x, stress.row[r].x),
                       select(mask, one.row[r].y, stress.row[r].y),
                       select(mask, one.row[r].z, stress.row[r].z)};
    if (!g.computeEnergy) continue;
    for (int l = 0; l < 8; l++)
      if (c.lanesOf[k] >> l & 1) energy[l] = psi[l];
  }
  return softened;
}

/// Sets stress and energy density of a group by its laws, and returns the lanes that have softened.
template<class Laws, class Real>
THAW_INLINE unsigned respond(const LaneConstants& c, const GroupDeformation<Real>& g,
                             Mat3<Lanes<Real>>& stress, double energy[8]) {
  if (c.laws == 1) return respondBy<Laws>(*c.law[0], g, stress, energy);
  // These are copies, since data that a called function can access cannot stay in registers.
  const Mat3<Lanes<Real>> gradient = g.gradient, f = g.f;
  Mat3<Lanes<Real>> mixed{};
  const unsigned softened = respondMixed<Laws, Real>(c, {c.lambda, c.mu, gradient, f, g.computeEnergy}, mixed,
                                                     energy);
  stress = mixed;
  return softened;
}

}  // namespace THAW_ISA
}  // namespace thaw
