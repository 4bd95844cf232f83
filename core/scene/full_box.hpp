// Liquid that fills a periodic box: it has no surface anywhere.
#pragma once
#include "core/scene/scene.hpp"

namespace thaw {

/// Whether one box of liquid fills a domain that is periodic along all axes, with nothing else in the scene.
bool liquidFillsTheBox(const Scene& scene);

/// True if a material in use has surface tension.
bool someSurfaceTension(const Scene& scene);

}  // namespace thaw
