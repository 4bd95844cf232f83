// Liquid slips along solids.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Sets Continuum::relief. Equal pressures push particles of a liquid to evenly spaced places, and so keep
/// the first layers on the particles of a solid. The force of the mean pressure p_i on liquid beside a solid,
/// -2 p_i V_i grad C_i, is reduced by a fixed share. The solid's particles receive the opposite force.
/// Requires: concentration gradients with the contributions of walls, carried densities of this step.
void findLatticeRelief(World& world, const StepTools& tools);

}  // namespace thaw
