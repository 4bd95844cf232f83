// SPDX-License-Identifier: Apache-2.0
// Pressure of a brush averaged over a step, along its path and its schedule.
#pragma once
#include <vector>

#include "core/scene/sheet_body.hpp"

namespace thaw {

/// Sample of a brush on its path, and its fraction of the pressure.
struct PressureSample {
  Vec3d centre{};
  double share = 0;
};

/// Returns samples of a brush whose mean is its pressure over dt (s) around `time` (s). Successive steps
/// cover the whole path. It is one sample at `time` if dt is 0, or if the brush is at rest and its factor
/// constant.
std::vector<PressureSample> pressureSamples(const PressureBrush& brush, double time, double dt);

/// Returns the pressure (Pa) at a position.
Vec3d brushPressure(const PressureBrush& brush, const std::vector<PressureSample>& samples,
                    const Vec3d& place);

}  // namespace thaw
