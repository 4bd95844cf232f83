// SPDX-License-Identifier: Apache-2.0
// Frame times, and lengths of steps that hit them.
#pragma once
#include <cstdint>

#include "core/time/clock.hpp"

namespace thaw {

/// frameTime returns the time (s) of a frame. It is the end if both differ only by rounding. frameDue returns
/// true if the next frame is due now.
double frameTime(const Clock& clock, std::int64_t frame);
bool frameDue(const Clock& clock);

/// Returns the longest step (s) up to dt (s) such that a whole number of steps reaches exactly the next frame
/// time or the end. All steps are shortened slightly, instead of the last one strongly. Steps that vary
/// periodically would pump energy into fast oscillations (docs/validation/stability.md, row 10).
double clip(const Clock& clock, double dt);

/// Returns the next step (s), at most Clock::dt. It equals the last step where possible. Limits that vary by
/// one or two per cent, as with oscillating stretch, then do not change the step. Where limits do vary, this
/// takes 2 to 4 % more steps (scenes/melt.toml). A changed step is aligned with frame times. The result
/// depends on the clock alone, which is in every checkpoint.
double nextStep(const Clock& clock);

/// Returns the longest step (s) without any limit: from frame to frame, or to the end of a scene without
/// frames.
double longestUnlimitedStep(const Clock& clock);

/// Returns the time after a step of dt: exactly the frame time or the end if clip aligned the step.
double timeAfter(const Clock& clock, double dt);

}  // namespace thaw
