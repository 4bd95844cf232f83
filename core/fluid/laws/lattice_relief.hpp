// SPDX-License-Identifier: Apache-2.0
// Liquid slips along solids.
#pragma once
#include "core/math/vec3.hpp"

namespace thaw {

/// A liquid particle beside a solid, inside the liquid.
struct ReliefInput {
  double pressure;    ///< Pa
  double volume;      ///< m^3
  double solidShare;  ///< share of solid neighbours in the relative density
  double support;     ///< m
  Vec3d gradient;     ///< 1, h times the gradient of the relative density, walls included
};

/// Force (N) on the particle from all its solid neighbours (Continuum::relief). Equal pressures push
/// particles of a liquid to evenly spaced places, and so keep the first layers on the particles of a solid.
/// The force of the mean pressure p_i on liquid beside a solid, -2 p_i V_i grad C_i, is reduced by a fixed
/// share. The solid's particles receive the opposite force.
Vec3f latticeRelief(const ReliefInput& input);

}  // namespace thaw
