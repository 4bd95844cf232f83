// Leap-frog in its kick-drift-kick form (K05 3.4; Springel 2005 section 4): positions and velocities are
// known at the same time.
#pragma once
#include <span>

#include "core/particles/row_span.hpp"
#include "core/time/limits.hpp"

namespace thaw {

/// Half a kick with the last acceleration, then the drift over dt. Viscous forces are then evaluated at the
/// half step's velocity. rows: of the owned ones, ascending; the others neither move nor accelerate
/// (core/sleep/sleep.hpp: awakeRows). Returns whether one of the particles that it moved is beyond an open
/// side.
bool kickAndDrift(World& world, double dt, std::span<const RowSpan> rows);

/// Accelerations from the summed forces and gravity, and the second half kick. Clamped particles stay, and
/// rows that are in none of the ranges. Adds up what was dissipated. Returns false where a position, velocity
/// or force is not finite, or a particle would pass its support radius in such a step: *bad is then the row
/// of the first such particle. *largest: what largestRates would find.
bool finishKick(World& world, double dt, std::span<const RowSpan> rows, std::size_t* bad,
                LargestRates* largest);

/// The sum of all forces (N) on an owned particle that the last kick was of, weight excluded; between steps,
/// where Continuum::force may be the acceleration by now.
Vec3d forceOf(const World& world, std::size_t row);

}  // namespace thaw
