// Surface tension as a stress along the surface (continuous surface stress: Lafaurie et al. 1994; in SPH Hu & Adams 2006, J. Comput. Phys. 213,
// 844), for a liquid with a free surface: T = sigma a (1 - n n), n along g = sum V grad W, a the area per volume. Three things differ:
// - T is divided by the tangential part of the neighbourhood's moment, so that the pairs' virial is T however the particles lie.
// - Along n there is no pull in T, and a particle that has left the layer flies off: a drop that swings loses a tenth of its particles in two
//   periods. So half of sigma a n n is added, which the pressure of the layer balances; what that pressure takes from the tension is made up for
//   by the factor 1 + .35 n M n. The .35 is measured on drops, not derived.
// - a goes like surfaceShare / sqrt|g|, which counts particles of the layer. With a = k |g| the pressure in a drop is too high by some 3.4 dx / R:
//   |g| is more where the surface is convex. Measured on drops as well.
// A wall covers the surface: it takes its part of g away and does not pull. Solids count in g like liquid.
// Momentum is kept to rounding. Energy is not: the force is no gradient of sigma a V, and liquids as thin as
// mu < .06 sqrt(rho sigma dx) are stirred by it until they boil (a drop of R / dx = 8 does at .03, not at .057; artificial viscosity of .05 stops
// it). Therefore not the default.
#pragma once
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Share of a particle's colour gradient (|g| h) that counts as surface: 0 below .3, where disorder inside the liquid makes it (accuracy.md B24).
double surfaceShare(double gradient);

/// Factor of a: a column of particles below a flat surface of the scene's lattice adds up to the area of its face.
double surfaceAreaScale(const Numerics& numerics);

/// Energy (J/m^3) of a surface at a particle with this gradient (|g| h); h support (m).
double surfaceEnergy(double tension, double areaScale, double h, double gradient);

/// grad W h^4 at x (in units of h) of the other particle.
Vec3d kernelGradient(KernelKind kernel, const Vec3d& x);

/// Continuum::surfaceStress of owned particles: T over the tangential part of the neighbourhood's moment, so that the pairs' virial is T, however
/// the particles lie. Walls cover the surface. Adds the surface's energy sigma a V to Continuum::interaction.
/// Needs colourGradient and surfaceMoment of owned particles.
void findSurfaceStress(const WallContext& context, double areaScale, const WallContacts& contacts);

}  // namespace thaw
