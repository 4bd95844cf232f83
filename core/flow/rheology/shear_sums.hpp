// SPDX-License-Identifier: Apache-2.0
// Sums for shear rates, with one set of functions per instruction set.
#pragma once
#include <cstdint>

#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/math/mat3.hpp"

namespace thaw {

/// Sums over the neighbours j of a particle, with weights a = V_j |W'| / q times the liquid fraction of the
/// pair. Here d is the position difference in support radii, q its length, u the velocity difference.
struct ShearMoments {
  double moment[6] = {};    ///< 1, a d d: XX YY ZZ XY YZ XZ
  double velocity[9] = {};  ///< m/s, a u d, by rows of u
  double liquid = 0;        ///< liquid fraction of the particle
};

/// Receives the sums of the rows in groups with liquid.
struct ShearSums {
  void* context = nullptr;
  void (*finish)(void* context, std::uint32_t row, const ShearMoments& sums) = nullptr;
};

struct ShearKernels {
  const char* name;  ///< "avx512", "avx2", "base"
  void (*sum)(const PairSums&, const ShearSums&, GroupRange);
};

/// Returns the set of that name, or the best one for this processor if the name is empty. Returns nullptr for
/// unknown or unsupported names.
const ShearKernels* shearKernels(const char* name = "");

/// Returns the shear rate times h (m/s): sqrt(2 D:D), D the strain rate without its trace. The velocity
/// gradient G minimises the sum of a |u - G d|^2. A small Tikhonov term keeps the rate finite for particles
/// with few neighbours. In linear flows the relative error of the shear rate is at most 1e-4.
double shearRateOf(const ShearMoments& sums);

}  // namespace thaw
