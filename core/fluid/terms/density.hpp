// Density. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Filling (SPH density over rest density): delta_i = sum_j V0_j W_ij / (its value on the lattice), the particle included, less PairSums::selfExcess: then it
/// is 1 on the lattice and grows with compression there as the density does, which at h = 2 dx the plain sum does by .95 only (as Dehnen & Aly 2012
/// eq. 18 correct it; .95 also on bcc and fcc).
template<class Real, class Kernel> struct Density {
  using L = Lanes<Real>;
  const Record<Real>* place;
  float* filling;
  std::int64_t* coincident;
  double scale, selfExcess;
  using Data = Lanes4<Real>;
  struct Sum { L filling = L(0.0), closest = L(1.0); };
  THAW_INLINE Data load(const std::uint32_t* rows) const { return thaw::THAW_ISA::load(place, rows); }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L q2 = square(positionDifference(i.a, j.a)) + square(positionDifference(i.b, j.b)) + square(positionDifference(i.c, j.c));
    s.filling += j.d * Kernel::w(q2);
    s.closest = select(j.d > L(0.0), min(s.closest, q2), s.closest);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    const L total = s.filling + i.d * Kernel::w(L(0.0));
    const bool touching = any(s.closest < L(1e-20));
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        filling[rows[l]] = static_cast<float>(scale * static_cast<double>(total[l]) - selfExcess * static_cast<double>(i.d[l]));
        if (touching && s.closest[l] < Real(1e-20)) ++*coincident;
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
