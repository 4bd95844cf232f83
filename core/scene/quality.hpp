// One word for a set of numerical choices (docs/validation/accuracy.md says what each costs and gives).
#pragma once
#include "core/scene/scene.hpp"

namespace thaw {

/// The defaults of Numerics for a quality; keys that the scene gives itself are read afterwards and win.
void applyQuality(Quality quality, Numerics& numerics);
/// The same of a material.
void applyQuality(Quality quality, Material& material);

}  // namespace thaw
