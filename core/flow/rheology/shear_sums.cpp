// SPDX-License-Identifier: Apache-2.0
#include "core/flow/rheology/shear_sums.hpp"

#include <cmath>

#include "core/simd/choose.hpp"

namespace thaw {

THAW_CHOOSE(ShearKernels, shearKernelSet, shearKernels)

double shearRateOf(const ShearMoments& s) {
  constexpr double regular = 0.003;  // fraction of the trace; a third of the trace is the moment inside a
                                     // liquid
  const double* const m = s.moment;
  const double* const v = s.velocity;
  const Mat3d moment = full(Sym3d{m[0], m[1], m[2], m[3], m[4], m[5]});
  const double delta = regular * (m[0] + m[1] + m[2]);
  if (!(delta > 0)) return 0;
  const Mat3d square = moment * moment + (delta * delta) * identity3<double>();
  const Mat3d velocity{{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}}};
  Sym3d rate = symmetric(velocity * (moment * inverse(square)));
  const double third = trace(rate) / 3;
  rate.xx -= third, rate.yy -= third, rate.zz -= third;
  return std::sqrt(2 * doubleDot(rate, rate));
}

}  // namespace thaw
