// Coefficients of sheets that change in time: their factors at the forces of now, and the work of changing them (DS section 3.2). What is stored in a spring whose
// stiffness grows grows with it: that comes from outside.
#pragma once
#include "core/world.hpp"

namespace thaw {

/// Takes over the factors at the end of a step of dt (s; 0 at the start). Before forces are found.
void findFactors(World& world, double dt);

/// Activates Sheets::changing where a spring, a volume, a push or a pull changes in time.
void activateChanging(World& world);

/// Place in Sheets::changing.
inline constexpr std::size_t firstChanging = placeOf(SheetFactor::Warp), lastChanging = placeOf(SheetFactor::Pull);
inline double& changingOf(Sheets& s, std::size_t i, SheetFactor f) {
  const std::size_t k = placeOf(f) - firstChanging;
  return s.changing[i].row[k / 3][static_cast<int>(k % 3)];
}

/// Work of what changes between two times (s), by half of what is stored now: once at either end of a step, so that a step has the mean.
void bookChanging(World& world, double from, double to);

}  // namespace thaw
