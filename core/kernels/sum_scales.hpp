// SPDX-License-Identifier: Apache-2.0
// Constants of the sums over neighbours. They follow from the kernel and the spacing.
#pragma once
#include "core/kernels/viscous_weight.hpp"

namespace thaw {

struct SumScales {
  ViscousWeight viscousWeight;      ///< for pairwise viscosity
  double inverseLatticeSum = 1;     ///< factor that turns sums over V W into relative densities
  double relativeDensityScale = 1;  ///< inverseLatticeSum / h^3
  double selfExcess = 0;       ///< subtracted from a particle's relative density, per V0 / h^3 of its own
                               ///< (terms/density.hpp)
  double conductionScale = 1;  ///< for heat conduction (kernels/lattice.hpp)
};

}  // namespace thaw
