// Surface tension as an energy of the surface, for liquids with a free surface. A particle of volume V has
//   E = sigma V C (A / h n^2 / fill^4 + B / dx (1 - cover)^2),
// n = h |sum V grad W|, cover = sum V W of its neighbours over that of the full lattice (0 alone, 1 inside; more counts as 1), fill the same with
// the particle itself; and where fill is less than at the edge of a lattice, see below. The first term is the surface: the square of n, not n itself, because disorder inside the liquid, where n is small, must
// cost nothing. Without the power of the filling the energy goes like density^2 times area and blows drops up; the second power makes it depend
// on area alone; the fourth lets it hold the liquid together, too. The second term is for those that n does not see: a film of one
// layer, a thread, a drop of one particle. It is also what holds the liquid at rest density where no pressure does.
// Where there is less than at an edge of the lattice, n^2 / fill^4 of a particle that comes to a liquid would climb to 23 sigma dx^2 (17 times its weight, of 4.1 mm
// and 0.03 N/m) before it falls: drops of one particle hung 1.9 spacings over a puddle and hopped on floors. There the power goes over into a parabola in fill that is 0
// for the particle alone, and what is alone costs the surface of a sphere of its volume, (36 pi)^(1/3) sigma dx^2, by a square that ends at the same fill: nothing is left to climb.
// Forces are the slopes of the sum of E by the places, volumes held: the pair's is V_i V_j (H (u_i - u_j) + (s_i + s_j) grad W), with H the Hessian
// of W, u = dE/dn and s = dE/dcover per volume. So momentum, angular momentum and energy are kept. The kernel is surface_kernel.hpp's.
// Calibration: A makes the surface of the lattice cost sigma; C and B are such that packed drops (seeds 1 to 4, R / dx = 8 and 12) have Laplace's
// pressure in their equation of state and swing in the period of the second mode, both; with B = 3 the two differ. Not from a lattice: a drop cut
// out of one keeps the symmetry of the cube and rests with a pressure 16 to 20 % off that of packed ones, to either side. At supports other than 2,
// C is from the pressure alone. The power is measured, too.
// What it does not do: the energy depends on how the particles lie. Those at the surface arrange themselves in shells, and the energy falls to a
// third of sigma times the area; inside, disorder leaves some cover open, which pulls, so that the pressure of all forces is about a third of the
// equation of state's. Shells resist as a soft solid does: waves are damped three times as much as viscosity would.
// Walls are as liquid: they cover the surface and pull on nothing but its gradient, a contact angle of 90 degrees. Solids likewise.
#pragma once
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// What is the same for all particles of a scene.
struct SurfaceMeasure {
  double support = 0, spacing = 0;  ///< m, h and dx
  double area = 0, thin = 0;        ///< 1, C A and C B
  double self = 0, full = 1;        ///< 1, V W of a particle itself, and of the others on the lattice
  double least = 0, sparse = 0;     ///< 1, fill of a particle alone, and that below which there is less than a surface
  double alone = 0;                 ///< 1, what a particle alone costs beyond `thin`
};
SurfaceMeasure surfaceMeasure(const Numerics& numerics, double spacing);

/// Energy per volume (J/m^3) of a particle and its slopes by gradient and cover (not yet over the full one), Pa.
struct SurfaceState { double energy = 0; Vec3d pull{}; double draw = 0; };
SurfaceState surfaceState(const SurfaceMeasure& measure, double tension, const Vec3d& gradient, double cover);

/// h grad W and W (h^-3) at x (in units of h) from the other particle.
struct SurfaceShare { Vec3d gradient{}; double cover = 0; };
SurfaceShare surfaceShare(const Vec3d& x);

/// A flat wall's part of the cover at a distance (h), with its first and second derivative: layers at half and whole spacings (h) below its surface,
/// each smeared over its plane, as in the tables of walls.
struct WallCover { double cover = 0, slope = 0, bend = 0; };
WallCover wallCover(double spacing, double distance);

/// Adds the walls to surfaceGradient and surfaceCover of owned particles; finds surfacePull and surfaceDraw, and adds E to Continuum::interaction.
void findSurfaceEnergy(const WallContext& context, const SurfaceMeasure& measure, const WallContacts& contacts);

/// N, along the contact's normal: what the wall adds to the slope of the particle's own energy.
double surfaceForceOfWall(const World& world, const WallContact& contact);

}  // namespace thaw
