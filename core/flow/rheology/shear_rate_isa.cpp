// SPDX-License-Identifier: Apache-2.0
// The sums of shear_sums.hpp, compiled once per instruction set.
#include "core/flow/rheology/shear_sums.hpp"
#include "core/fluid/terms/choose_types.hpp"
#include "core/fluid/terms/term.hpp"
#include "core/simd/isa_name.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Computes the ShearMoments of particles. It is a term of the pair sums (core/fluid/terms/term.hpp).
template<class Real, class Kernel> struct ShearRate {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *velocityViscosity, *pressurePhaseHeat;
  const ShearSums* out;
  struct Data {
    Lanes4<Real> positionVolume, velocityViscosity, pressurePhaseHeat;
  };
  /// Liquid fraction; its record is negative at the free surface, with carried densities.
  static THAW_INLINE L liquidOf(const Data& of) {
    return max(of.pressurePhaseHeat.b, L(0.0) - of.pressurePhaseHeat.b);
  }
  struct Sum {
    L moment[6] = {}, velocity[9] = {};
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(velocityViscosity, entries),
            loadListed(pressurePhaseHeat, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L d[3] = {positionDifference(i.positionVolume.a, j.positionVolume.a),
                    positionDifference(i.positionVolume.b, j.positionVolume.b),
                    positionDifference(i.positionVolume.c, j.positionVolume.c)};
    const L u[3] = {i.velocityViscosity.a - j.velocityViscosity.a,
                    i.velocityViscosity.b - j.velocityViscosity.b,
                    i.velocityViscosity.c - j.velocityViscosity.c};
    const L q2 = dot3(d[0], d[1], d[2], d[0], d[1], d[2]);
    const L fi = liquidOf(i), fj = liquidOf(j);
    const L a = (fi * fj - fi - fj) * j.positionVolume.d * Kernel::slope(sqrt(q2), q2);
    const L ad[3] = {a * d[0], a * d[1], a * d[2]};
    constexpr int first[6] = {0, 1, 2, 0, 1, 0}, second[6] = {0, 1, 2, 1, 2, 2};
    for (int k = 0; k < 6; k++) s.moment[k] = fma(ad[first[k]], d[second[k]], s.moment[k]);
    for (int k = 0; k < 3; k++)
      for (int l = 0; l < 3; l++) s.velocity[3 * k + l] = fma(u[k], ad[l], s.velocity[3 * k + l]);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    const L f = liquidOf(i);
    for (int l = 0; l < 8; l++) {
      if (rows[l] == dummy) continue;
      ShearMoments m;
      for (int k = 0; k < 6; k++) m.moment[k] = static_cast<double>(s.moment[k][l]);
      for (int k = 0; k < 9; k++) m.velocity[k] = static_cast<double>(s.velocity[k][l]);
      m.liquid = static_cast<double>(f[l]);
      out->finish(out->context, rows[l], m);
    }
  }
};

void sum(const PairSums& in, const ShearSums& out, GroupRange range) {
  chooseTypes(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    ShearRate<Real, decltype(kernel)> term{records<Real>(in.positionVolume),
                                           records<Real>(in.velocityViscosity),
                                           records<Real>(in.pressurePhaseHeat), &out};
    sweep(*in.lists, range, term, Groups::Fluid);
  });
}

}  // namespace

const ShearKernels& shearKernelSet();
const ShearKernels& shearKernelSet() {
  static constexpr ShearKernels set{isaName, sum};
  return set;
}

}  // namespace THAW_ISA
}  // namespace thaw
