// SPDX-License-Identifier: Apache-2.0
// Stress and energy of eight solids by the laws of the library (core/solid/laws/laws.hpp), inlined into the
// bond loops, and by those of extensions. Only code for one instruction set includes this.
#pragma once
#include <type_traits>

#include "core/solid/elasticity/elastic_lanes.hpp"
#include "core/solid/laws/extension_law_lanes.hpp"
#include "core/solid/laws/laws.hpp"

namespace thaw {
namespace THAW_ISA {

THAW_INLINE Mat3<LanesD> select(MaskD m, const Mat3<LanesD>& a, const Mat3<LanesD>& b) {
  Mat3<LanesD> r;
  for (int k = 0; k < 3; k++)
    r.row[k] = {select(m, a.row[k].x, b.row[k].x), select(m, a.row[k].y, b.row[k].y),
                select(m, a.row[k].z, b.row[k].z)};
  return r;
}

/// The function for one F (core/solid/laws/corotated.hpp) for eight. Each lane stops independently, so its
/// bits do not depend on its group. Lanes where Newton's iteration does not apply (nearly singular or
/// inverted F) are found one by one.
THAW_INLINE Mat3<LanesD> nearestRotation(const Mat3<LanesD>& f) {
  const LanesD size = doubleDot(f, f) / LanesD(3.0);
  const MaskD usable = determinant(f) > LanesD(newtonsShare) * size * sqrt(size);
  Mat3<LanesD> rotation = select(usable, f, identity3<LanesD>());
  MaskD going = usable;
  for (int n = 0; n < newtonsSteps && any(going); n++) {
    const Mat3<LanesD> next = towardsRotation(rotation), change = next - rotation;
    rotation = select(going, next, rotation);
    going = going & (doubleDot(change, change) > LanesD(newtonsEnd));
  }
  const MaskD hard{~usable.lo | going.lo, ~usable.hi | going.hi};
  if (!any(hard)) return rotation;
  alignas(64) double from[9][8], to[9][8];
  storeMatrix<double>(f, from), storeMatrix<double>(rotation, to);
  for (int l = 0; l < 8; l++)
    if (laneOf(hard, l)) nearestRotationOfLane(from, l, to);
  return loadMatrix<double>(to);
}

THAW_INLINE Mat3<LanesD> plusOne(Mat3<LanesD> f) {
  f.row[0].x += LanesD(1.0);
  f.row[1].y += LanesD(1.0);
  f.row[2].z += LanesD(1.0);
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
  const LaneConstants& c;
  const Mat3<Lanes<Real>>&gradient, &f;  ///< F - 1, F
  bool wantEnergy;
  template<class T> THAW_INLINE LawPoint<T> pointOf(const LawValues& values) const {
    if constexpr (std::is_same_v<T, Lanes<Real>>) {
      return {f, fromDoubles<Real>(c.lambda), fromDoubles<Real>(c.mu), values, gradient};
    } else {
      const Mat3<T> wide = widened(gradient);
      return {plusOne(wide), loadRow(c.lambda), loadRow(c.mu), values, wide};
    }
  }
};

/// Sets stress (Pa, first Piola) and, if wanted, energy density (Pa) of all lanes by a law of the library.
/// Returns the lanes that have softened, as LawDefaults says.
template<class Law, class Real>
THAW_INLINE unsigned respondInline(const GroupDeformation<Real>& g, const LawValues& values,
                                   Mat3<Lanes<Real>>& stress, double energy[8]) {
  using Stress = std::conditional_t<Law::doubleStress, LanesD, Lanes<Real>>;
  using Energy = std::conditional_t<Law::doubleEnergy, LanesD, Lanes<Real>>;
  const LawPoint<Stress> at = g.template pointOf<Stress>(values);
  const auto shared = sharedOf<Law>(at);
  stress = narrowed<Real>(stressOf<Law>(at, shared));
  if (g.wantEnergy) {
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

/// The same by any law.
template<class Real>
THAW_INLINE unsigned respondBy(const BoundLaw& law, const GroupDeformation<Real>& g,
                               Mat3<Lanes<Real>>& stress, double energy[8]) {
  unsigned softened = 0;
  const auto inlined = [&]<class Law>() __attribute__((always_inline)) {
    softened = respondInline<Law>(g, law.values, stress, energy);
  };
  if (BuiltInLaws::at(law.law->builtIn, inlined)) return softened;
  alignas(64) double gradient[9][8], piola[9][8];
  storeMatrix<Real>(g.gradient, gradient);
  respondGroup(*law.law, {gradient, g.c.lambda, g.c.mu, law.values, piola, g.wantEnergy ? energy : nullptr});
  stress = loadMatrix<Real>(piola);
  return 0;
}

/// The same for a group of several laws. It is a separate function: few groups have several, and the loop
/// over groups stays short.
template<class Real>
__attribute__((noinline, flatten)) unsigned respondMixed(const GroupDeformation<Real>& g,
                                                         Mat3<Lanes<Real>>& stress, double energy[8]) {
  unsigned softened = 0;
  for (int k = 0; k < g.c.laws; k++) {
    Mat3<Lanes<Real>> one{};
    alignas(64) double psi[8]{}, ours[8];
    softened |= respondBy(*g.c.law[k], g, one, psi) & g.c.lanesOf[k];
    for (int l = 0; l < 8; l++) ours[l] = g.c.lanesOf[k] >> l & 1;
    const auto mask = Lanes<Real>(Real(0.5)) < fromDoubles<Real>(ours);
    for (int r = 0; r < 3; r++)
      stress.row[r] = {select(mask, one.row[r].x, stress.row[r].x),
                       select(mask, one.row[r].y, stress.row[r].y),
                       select(mask, one.row[r].z, stress.row[r].z)};
    if (!g.wantEnergy) continue;
    for (int l = 0; l < 8; l++)
      if (g.c.lanesOf[k] >> l & 1) energy[l] = psi[l];
  }
  return softened;
}

/// Sets stress and energy density of a group by its laws, and returns the lanes that have softened.
template<class Real>
THAW_INLINE unsigned respond(const GroupDeformation<Real>& g, Mat3<Lanes<Real>>& stress, double energy[8]) {
  if (g.c.laws == 1) return respondBy(*g.c.law[0], g, stress, energy);
  // Copies: data that a called function can access cannot be in registers.
  const Mat3<Lanes<Real>> gradient = g.gradient, f = g.f;
  Mat3<Lanes<Real>> mixed{};
  const unsigned softened = respondMixed<Real>({g.c, gradient, f, g.wantEnergy}, mixed, energy);
  stress = mixed;
  return softened;
}

}  // namespace THAW_ISA
}  // namespace thaw
