// SPDX-License-Identifier: Apache-2.0
// Presets of numerical choices (docs/validation/accuracy.md gives their cost and accuracy).
#pragma once
#include "core/scene/scene.hpp"

namespace thaw {

/// Sets the defaults of Numerics for a quality. The scene's own keys are read afterwards and take precedence.
void applyQuality(Quality quality, Numerics& numerics);
/// Sets the defaults of Material for a quality.
void applyQuality(Quality quality, Material& material);

}  // namespace thaw
