// Liquid that fills a periodic box: it has no surface anywhere.
#pragma once
#include "core/scene/scene.hpp"

namespace thaw {

/// Whether one box of liquid fills a domain that is periodic along all axes, with nothing else in the scene.
bool liquidFillsTheBox(const Scene& scene);

/// Whether there is nothing but liquid without weight and surface tension: no solid, wall, obstacle, emitter or other type of body.
bool liquidIsFree(const Scene& scene);

}  // namespace thaw
