// SPDX-License-Identifier: Apache-2.0
// Liquid slips along solids.
#pragma once
#include <cstdint>
#include <span>

#include "core/materials/liquid_materials.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct ReliefContext {
  std::span<const LiquidMaterial> liquids;
  const Numerics& numerics;
  double support;                        ///< m
  std::span<const std::uint8_t> asleep;  ///< per row, not 0: skipped; empty: none
};

/// Sets Continuum::relief. Equal pressures push particles of a liquid to evenly spaced places, and so keep
/// the first layers on the particles of a solid. The force of the mean pressure p_i on liquid beside a solid,
/// -2 p_i V_i grad C_i, is reduced by a fixed share. The solid's particles receive the opposite force.
/// Requires: concentration gradients with the contributions of walls, carried densities of this step.
void findLatticeRelief(const ReliefContext& context, Continuum& particles);

}  // namespace thaw
