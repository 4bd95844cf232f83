// SPDX-License-Identifier: Apache-2.0
// Test for a liquid that fills a periodic box, so it has no surface.
#pragma once
#include "core/scene/scene.hpp"

namespace thaw {

/// Returns true if one box of liquid fills a domain that is periodic along all axes, and the scene contains
/// nothing else.
bool liquidFillsTheBox(const Scene& scene);

/// Returns true if a material in use has surface tension.
bool someSurfaceTension(const Scene& scene);

}  // namespace thaw
