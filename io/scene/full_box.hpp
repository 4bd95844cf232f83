// Liquid that fills a periodic box has no free surface, and other choices of the method are best for it.
#pragma once
#include "core/scene/scene.hpp"

namespace thaw {

/// Whether one box of liquid fills a domain that is periodic along all axes, with nothing else in the scene.
bool liquidFillsTheBox(const Scene& scene);

/// Choices of [numerics] that the scene does not make itself.
struct OpenChoices { bool density = true, tensileLimit = true, shifting = true; };

/// Where liquid fills the box (and the equation of state is used) it cannot tear, and no neighbourhood is cut off: negative pressures are kept,
/// the flow carries the density and particles are shifted. Taylor-Green vortices need it (docs/accuracy.md): without, half their energy is lost.
void chooseForFullBox(Scene& scene, const OpenChoices& open);

}  // namespace thaw
