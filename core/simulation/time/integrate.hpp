// SPDX-License-Identifier: Apache-2.0
// Leap-frog in kick-drift-kick form (K05 3.4; SP05 section 4). Positions and velocities are known at the same
// time.
#pragma once
#include <span>

#include "core/particles/row_span.hpp"
#include "core/simulation/time/limits.hpp"

namespace thaw {

/// Applies half a kick with the last acceleration, then the drift over dt (s). Viscous forces are then
/// evaluated at the half-step velocity. rows: active owned rows, ascending. Other rows neither move nor
/// accelerate (awakeRows, core/sleep/sleep.hpp). Returns true if a moved particle is beyond an open side.
bool kickAndDrift(World& world, double dt, std::span<const RowSpan> rows);

/// Computes accelerations from forces and gravity and applies the second half kick. Clamped particles and
/// rows outside the ranges do not change. Accumulates dissipation. Returns false if a position, velocity or
/// force is not finite. Also returns false if a particle would move by more than its support radius in such a
/// step. *bad is then the first such row. *largest receives the result of largestRates.
bool finishKick(World& world, double dt, std::span<const RowSpan> rows, std::size_t* bad,
                LargestRates* largest);

/// Returns the total force (N) of the last kick on an owned particle, without weight. Valid between steps,
/// where Continuum::force may hold the acceleration.
Vec3d forceOf(const Continuum& particles, const Scene& scene, std::size_t row);

}  // namespace thaw
