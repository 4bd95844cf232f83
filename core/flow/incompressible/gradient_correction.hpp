// SPDX-License-Identifier: Apache-2.0
// Corrected gradients (BL99) of the incompressible solver. Without them, a lattice under pressure resists
// shear like an elastic solid with a shear modulus in proportion to the pressure.
#pragma once
#include "core/flow/incompressible/pressure_system.hpp"

namespace thaw {

/// Sets Continuum::correction of all rows and PressureWork::inside of owned rows. Requires:
/// PressureWork::moment and impulse of PairKernels::response, and PressureWork::walls. Collective.
void correctGradients(const PressureSystem& system);

}  // namespace thaw
