// SPDX-License-Identifier: Apache-2.0
// Default choices of the method for liquids, in a full periodic box or with a free surface.
#pragma once
#include <cstdint>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// Smallest support of tension by curvature: a particle of the surface needs neighbours on it.
constexpr double leastCurvatureSupport = 1.9;

/// Settings that the scene leaves open: choices of [numerics], and the packing of its only body. True: open.
struct OpenChoices {
  bool density = true, tensileLimit = true, shifting = true, tension = true;
  bool viscosityCorrection = true, packing = true;
  std::vector<std::uint8_t> artificialViscosity;  ///< per material: 1 if open
  std::vector<std::uint8_t> bulkDamping;          ///< the same
};

/// Sets the defaults of liquid that fills the box (liquidFillsTheBox) with the equation of state. It cannot
/// tear and has no free surface, so negative pressure is kept, the density is carried and particles are
/// shifted. Particles start without a lattice. A lattice that the flow stretches by e^0.3 has 1.5 times too
/// much resistance until shifting has dissolved it. Only then is the viscosity right within 2 %. A lattice
/// remains if the temperature varies at the start, since it has the most accurate heat conduction.
/// Taylor-Green vortices need all of these choices (docs/validation/accuracy.md). Particles of the
/// incompressible solver start without a lattice, too. Liquid whose weight is left out (Buoyancy::Boussinesq)
/// fills a closed domain. With the equation of state it gets these defaults as well, but keeps its lattice.
/// Without its weight, pressure that cannot be negative would open gaps.
void chooseForFullBox(Scene& scene, const OpenChoices& open);

/// Sets the defaults of liquids with a free surface: carried density, negative pressure and particle
/// shifting. With summed densities stretched liquid breaks up, and its lattice resists shear at rest.
/// Artificial viscosity damps the noise of particles if the viscosity of a liquid is too small for it.
/// Surface tension acts by the curvature. Summed densities and the surface energy remain the defaults with
/// quality = "preview", printed pressure and the incompressible solver. A scene that sets another form of
/// tension gets summed densities, for which these forms are calibrated.
void chooseForLiquids(Scene& scene, const OpenChoices& open);

/// Switches the correction of the viscosity on if the viscosity of a liquid limits explicit steps more than
/// sound does. Such liquids keep their initial lattice for a long time, others lose it soon.
void chooseForThickLiquids(Scene& scene, const OpenChoices& open);

}  // namespace thaw
