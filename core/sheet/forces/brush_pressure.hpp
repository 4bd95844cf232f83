// SPDX-License-Identifier: Apache-2.0
// Pressure of a brush, averaged over a step along its path and its time factor.
#pragma once
#include <vector>

#include "core/scene/sheet_body.hpp"

namespace thaw {

/// Sample of a brush on its path (centre: m), and its fraction of the pressure (1).
struct PressureSample {
  Vec3d centre{};
  double share = 0;
};

/// Returns samples of a brush that together give its mean pressure over dt (s) around `time` (s). Successive
/// steps cover the whole path. There is one sample at `time` if dt is 0, or if the brush is at rest and its
/// factor is constant.
std::vector<PressureSample> pressureSamples(const PressureBrush& brush, double time, double dt);

/// Returns the pressure (Pa) at a position.
Vec3d brushPressure(const PressureBrush& brush, const std::vector<PressureSample>& samples,
                    const Vec3d& place);

}  // namespace thaw
