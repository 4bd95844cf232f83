// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/laws/viscosity_factor.hpp"

#include <algorithm>

#include "core/math/mat3.hpp"

namespace thaw {
namespace {

/// Traceless strain rate times h (m/s).
Sym3d fittedStrainRate(const ViscousNeighbours& s) {
  const double* const m = s.second;
  const double* const v = s.velocity;
  const Mat3d moments{{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}}};
  Sym3d rate = symmetric(moments * inverse(full(Sym3d{m[0], m[1], m[2], m[3], m[4], m[5]})));
  const double third = (rate.xx + rate.yy + rate.zz) / 3;
  rate.xx -= third, rate.yy -= third, rate.zz -= third;
  return rate;
}

}  // namespace

double viscosityFactor(const ViscousNeighbours& s, double most) {
  constexpr double least = 0.5;
  // Neighbours are missing below a relative density of 0.95.
  const double complete = std::clamp((s.relativeDensity - 0.9) / 0.05, 0.0, 1.0);
  if (!(complete > 0)) return 1;
  const Sym3d rate = fittedStrainRate(s);
  const double D[6] = {rate.xx, rate.yy, rate.zz, rate.xy, rate.yz, rate.xz};
  const auto occurrences = [](int k) { return k < 3 ? 1 : 2; };  // number of a component in the full tensor
  double squared = 0, pairs = 0;                                 // D:D; sum of a (d.D d)^2
  for (int k = 0, at = 0; k < 6; k++) {
    const double Dk = occurrences(k) * D[k];
    squared += Dk * D[k];
    for (int l = k; l < 6; l++, at++) pairs += (l == k ? 1 : 2) * Dk * occurrences(l) * D[l] * s.fourth[at];
  }
  if (!(squared > 0)) return 1;
  const double exact = 4 * squared * (1 - s.wallShear);
  const double factor = exact < most * pairs ? std::max(exact / pairs, least) : most;
  return 1 + complete * (factor - 1);
}

}  // namespace thaw
