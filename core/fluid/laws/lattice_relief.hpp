// SPDX-License-Identifier: Apache-2.0
// Reduced pressure of liquid next to solids, so that its first layers slip along the solid.
#pragma once
#include "core/math/vec3.hpp"

namespace thaw {

/// A liquid particle inside the liquid and next to a solid.
struct ReliefInput {
  double pressure;    ///< Pa
  double volume;      ///< m^3
  double solidShare;  ///< share of solid neighbours in the relative density
  double support;     ///< m
  Vec3d gradient;     ///< 1, h times the gradient of the relative density, walls included
  Vec3d away;         ///< direction away from the solid, any length
};

/// Force (N) on the particle from all its solid neighbours (Continuum::relief). Equal pressures push
/// particles to evenly spaced positions. This binds the first layers of a liquid to the particles of a solid.
/// Next to a solid, a fixed share of this force is therefore removed. The removed force is the component
/// along the solid of -2 p_i V_i grad C_i. This term is due to the particle's own pressure. The solid's
/// particles receive the opposite force. The force has no potential, so liquid that slips along a solid gains
/// some energy. Solids that are fixed in place are excluded; next to these, nothing is removed.
Vec3f latticeRelief(const ReliefInput& input);

}  // namespace thaw
