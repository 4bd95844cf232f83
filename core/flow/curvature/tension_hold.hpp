// SPDX-License-Identifier: Apache-2.0
// Steps between evaluations of surface tension by curvature. Steps of sound or elastic waves are often much
// shorter than those that the tension needs, and its force changes little between them.
#pragma once
#include "core/scene/scene.hpp"
#include "core/time/clock.hpp"

namespace thaw {

/// Returns how long (s) the force may be held: a tenth of the step limit of tension, and no longer than
/// mu dx / (4 gamma). A force that is late by half of this time feeds waves of the wave number k with a rate
/// gamma k^3 dt / (4 rho), at most a tenth of their viscous decay 2 mu k^2 / rho. Liquids without a constant
/// or tabulated viscosity hold nothing.
double tensionHold(const Scene& scene);

/// Returns true if the evaluation that ends a step of dt (s) renews the force; dt = 0: at the start.
/// Requires: the clock at the beginning of the step.
bool isTensionDue(double hold, const Clock& clock, double dt);

}  // namespace thaw
