// SPDX-License-Identifier: Apache-2.0
// Interval between evaluations of surface tension by curvature. Sound or elastic waves often limit the step
// to much less than the limit of tension. The tension force then changes little from step to step.
#pragma once
#include "core/scene/scene.hpp"
#include "core/time/clock.hpp"

namespace thaw {

/// Returns the interval tau (s): a tenth of the step limit of tension, and no longer than mu dx / (4 gamma).
/// The mean delay of tau / 2 lets waves of the wave number k grow at a rate of gamma k^3 tau / (4 rho). Up to
/// k = pi / dx this is at most a tenth of their viscous decay 2 mu k^2 / rho. The interval is 0 without
/// tension, without viscosity, and with flow laws.
double tensionInterval(const Scene& scene);

/// Returns true if the force is evaluated at the end of a step of dt (s). dt = 0: at the start. The number of
/// steps between evaluations is the largest power of two, up to 64, that fits into the interval. When this
/// number changes, one number is a multiple of the other, so no evaluation is delayed for long. Requires: the
/// clock at the beginning of the step.
bool isTensionDue(double interval, const Clock& clock, double dt);

}  // namespace thaw
