// Where a brush presses over a step: it acts along its way, also where that is longer than its radius, and
// through all of its schedule.
#pragma once
#include <vector>

#include "core/scene/sheet_body.hpp"

namespace thaw {

/// Of a brush at one place of its way: what share of its pressure acts there.
struct BrushTouch {
  Vec3d centre{};
  double share = 0;
};

/// What stands for a brush in forces at `time` (s) of steps of dt (s): its mean over dt around that time, so
/// that the steps of a run leave nothing of its way out. One touch, the brush as it is at `time`, where over
/// dt it stands still and its factor is linear, or where dt is 0.
std::vector<BrushTouch> brushStroke(const SheetBrush& brush, double time, double dt);

/// Pa, at a place.
Vec3d brushPressure(const SheetBrush& brush, const std::vector<BrushTouch>& stroke, const Vec3d& place);

}  // namespace thaw
