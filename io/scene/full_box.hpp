// Liquid that fills a periodic box has no free surface, and other choices of the method are best for it.
#pragma once
#include <cstdint>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// Choices of [numerics], and of the body that fills the box, that the scene does not make itself.
struct OpenChoices {
  bool density = true, tensileLimit = true, shifting = true, packing = true;
  std::vector<std::uint8_t> artificialViscosity;  ///< by material: 1 where the scene does not give it
};

/// Where liquid fills the box (liquidFillsTheBox, and the equation of state is used) it cannot tear, and no
/// neighbourhood is cut off: negative pressures are kept, the flow carries the density and particles are
/// shifted. And they start without a lattice: one that the flow stretches by e^.3 resists it 1.5 times too
/// much until shifting has made an end of it, and only then is viscosity what it is to be within 2 %. A
/// lattice stays where the temperature varies at the start, since heat conduction is most accurate on it.
/// Taylor-Green vortices need all of it (docs/validation/accuracy.md): without, half their energy is lost.
/// With the incompressible solver they start without a lattice, too.
void chooseForFullBox(Scene& scene, const OpenChoices& open);

/// Defaults of liquids with a free surface: carried density, negative pressure and particle shifting.
/// With summed densities stretched liquid falls apart, and its lattice resists shear at rest.
/// Artificial viscosity damps the noise of particles where a liquid's own viscosity is too small for it.
/// Summation remains the default with surface tension (whose model is calibrated for it), quality =
/// "preview", printed pressure and the incompressible solver.
void chooseForLiquids(Scene& scene, const OpenChoices& open);

}  // namespace thaw
