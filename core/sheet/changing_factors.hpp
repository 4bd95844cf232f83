// Coefficients of sheets that change in time: their factors at the forces of now, and the work of changing
// them (DS section 3.2). What is stored in a spring whose stiffness grows grows with it: that comes from
// outside.
#pragma once
#include "core/world.hpp"

namespace thaw {

/// Takes over the factors at the end of a step of dt (s; 0 at the start). Before forces are found.
void findFactors(World& world, double dt);

/// Activates Sheets::changing where a spring, a volume, a push or a pull changes in time.
void activateChanging(World& world);

/// The longest next step (s), from now (s), for which what coefficients of a sheet change by is followed:
/// stableStep knows how stiff they are, not how fast they change. It ends where a change begins; while one
/// goes on, a step is a small part of it, and of a swing: with a coefficient held at its middle what is
/// missing of the motion is (rate step)^2 / 12 of the change. swing: 1/s, the fastest rate of the law's own
/// motion (damping, stiffness); of: 1/s, that of forces between neighbours.
double changeLimit(const SheetBody& body, double now, double swing, double of);

/// 1/s, the fastest rate of a vertex alone from a time on.
double fastestRate(const SheetBody& body, const SpringLaw& law, double from);

/// Place in Sheets::changing.
inline constexpr std::size_t firstChanging = placeOf(SheetFactor::Warp),
                             lastChanging = placeOf(SheetFactor::Pull);
inline double& changingOf(Sheets& s, std::size_t i, SheetFactor f) {
  const std::size_t k = placeOf(f) - firstChanging;
  return s.changing[i].row[k / 3][static_cast<int>(k % 3)];
}

/// Work of what changes between two times (s), by half of what is stored now: once at either end of a step,
/// so that a step has the mean.
void bookChanging(World& world, double from, double to);

}  // namespace thaw
