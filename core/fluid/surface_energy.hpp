// Surface tension as an energy of the surface, for liquids with a free surface. A particle of volume V has
//   E = sigma V (A / h n^2 / fill^2 + B / dx o^2 / (1 + 2 o^2)), o = 1 - cover,
// n = h |sum V grad W|, cover = sum V W of its neighbours over that of the full lattice (0 alone, 1 inside;
// more counts as 1), fill the same with the particle itself; and where fill is less than at the edge of a
// lattice, see below. The first term sees where the surface is: the square of n, not n itself, because
// disorder inside the liquid, where n is small, must cost nothing; its power of the filling makes it depend
// on area and not on density. The second is most of the energy, and holds the liquid together: a single layer
// has no n at all, so the first alone parts a liquid into layers like an onion's, 1.6 spacings apart, of
// particles .78 spacings apart. Their filling is 1, since the kernel's sum counts clumps more, their density
// is not: with less than a tenth of the energy in the second term, and the fourth power, drops of R / dx = 8
// and 12 swelled by 3.5 and 2 % in radius. It is also what films of one layer, threads and single particles
// have. Where there is less than at an edge of the lattice, n^2 / fill^2 of a particle that comes to a liquid
// would climb before it falls, and drops of one particle hang over a puddle and hop on floors. There the
// power goes over into a parabola in fill that is 0 for the particle alone, and what is alone costs the
// surface of a sphere of its volume, (36 pi)^(1/3) sigma dx^2: what the second term has not of it, by a
// square that ends at the same fill. Forces are the slopes of the sum of E by the places, volumes held: the
// pair's is V_i V_j (H (u_i - u_j) + (s_i + s_j) grad W), with H the Hessian of W, u = dE/dn and s =
// dE/dcover per volume. So momentum, angular momentum and energy are kept. The kernel is
// surface_kernel.hpp's. Calibration: A and B are such that of the energy C sigma of the lattice's surface .73
// are in the second term, and packed drops (R / dx = 8 and 12) have Laplace's pressure in their equation of
// state and swing in the period of the second mode, both; with less in the second term swings are too fast
// where the pressure is right. With the plain square of o drops swell by a hundredth at a third, and by less
// than .002 from half on. At supports other than 2, C and the share are from the pressure alone. What it does
// not do: the energy depends on how the particles lie. Those at the surface arrange themselves in shells, and
// the energy falls to a third of sigma times the area; inside, disorder leaves some cover open, which pulls,
// so that the pressure of all forces is about a third of the equation of state's, which falls as the inside
// gets its order (docs/validation/limitations.md). Shells resist as a soft solid does: waves are damped two
// to three times as much as viscosity would. Threads of particles in single file, .55 spacings apart, have
// two thirds of a cylinder's surface and three times its pull, and are spooled out of drops that should pinch
// off. Walls are as liquid: they cover the surface and pull on nothing but its gradient, a contact angle of
// 90 degrees. Solids likewise.
#pragma once
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// What is the same for all particles of a scene.
struct SurfaceMeasure {
  double support = 0, spacing = 0;  ///< m, h and dx
  double area = 0, thin = 0;        ///< 1, A and B
  double self = 0, full = 1;        ///< 1, V W of a particle itself, and of the others on the lattice
  double least = 0, sparse = 0;  ///< 1, fill of a particle alone, and that below which there is less than a
                                 ///< surface
  double alone = 0;              ///< 1, what a particle alone costs beyond `thin`
};
SurfaceMeasure surfaceMeasure(const Numerics& numerics, double spacing);

/// Energy per volume (J/m^3) of a particle and its slopes by gradient and cover (not yet over the full one),
/// Pa.
struct SurfaceState {
  double energy = 0;
  Vec3d pull{};
  double draw = 0;
};
SurfaceState surfaceState(const SurfaceMeasure& measure, double tension, const Vec3d& gradient, double cover);

/// h grad W and W (h^-3) at x (in units of h) from the other particle.
struct SurfaceShare {
  Vec3d gradient{};
  double cover = 0;
};
SurfaceShare surfaceShare(const Vec3d& x);

/// A flat wall's part of the cover at a distance (h), with its first and second derivative: layers at half
/// and whole spacings (h) below its surface, each smeared over its plane, as in the tables of walls.
struct WallCover {
  double cover = 0, slope = 0, bend = 0;
};
WallCover wallCover(double spacing, double distance);

/// Adds the walls to surfaceGradient and surfaceCover of owned particles; finds surfacePull and surfaceDraw,
/// and adds E to Continuum::interaction.
void findSurfaceEnergy(const WallContext& context, const SurfaceMeasure& measure,
                       const WallContacts& contacts);

/// N, along the contact's normal: what the wall adds to the slope of the particle's own energy.
double surfaceForceOfWall(const World& world, const WallContact& contact);

}  // namespace thaw
