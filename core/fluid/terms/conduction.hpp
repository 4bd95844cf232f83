// SPDX-License-Identifier: Apache-2.0
// Heat conduction only. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Heat conduction between solids, for groups without liquid nearby. Results equal those of Forces
/// (forces.hpp) bit by bit.
template<class Real, class Kernel> struct Conduction {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *pressurePhaseHeat;
  const PairSums* in;
  double heatScale;
  static constexpr double unit = lengthUnit<Real>;
  struct Data {
    Lanes4<Real> positionVolume, pressurePhaseHeat;
  };
  struct Sum {
    Lanes<double> heat = Lanes<double>(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(pressurePhaseHeat, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = unitDifference(i.positionVolume.a, j.positionVolume.a),
            dy = unitDifference(i.positionVolume.b, j.positionVolume.b),
            dz = unitDifference(i.positionVolume.c, j.positionVolume.c);
    const L r2 = dot3(dx, dy, dz, dx, dy, dz);
    s.heat += wide(conducted(i.positionVolume.d * j.positionVolume.d, i.pressurePhaseHeat,
                             j.pressurePhaseHeat, Kernel::laplace(L(unit) * sqrt(r2), L(unit * unit) * r2)));
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) in->heatFlow[rows[l]] += heatScale * s.heat[l];
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
