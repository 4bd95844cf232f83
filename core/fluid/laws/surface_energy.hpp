// SPDX-License-Identifier: Apache-2.0
// Surface tension as the gradient of a surface energy, for liquids with a free surface.
// A particle of volume V has
//   E = sigma V (A / h n^2 / d^2 + B / dx o^2 / (1 + 2 o^2)), o = 1 - colour.
// n = h |sum V grad W| is the gradient. The colour is sum V W over the neighbours, relative to the full
// lattice. It is 0 for a single particle and 1 inside; larger values count as 1. d is the same sum with the
// particle itself.
//
// Gradient term: it locates the surface. It is quadratic in n, so disorder inside the liquid, where n is
// small, costs little energy. The division by d^2 makes it depend on area and not on density.
//
// Colour term: it has most of the energy and holds the liquid together. A single layer has n = 0, so the
// gradient term alone splits a liquid into layers 1.6 spacings apart, of particles 0.78 spacings apart. Their
// relative density is 1, since the kernel sum overestimates clumps, but their true density is not. Films of
// one layer, threads and single particles have only this term.
//
// Sparse neighbourhoods: below the d of a lattice edge, n^2 / d^2 of a particle that approaches the liquid
// would rise before it falls. Single particles would hover over puddles and floors. There the power continues
// as a parabola in d that is 0 for a single particle. A single particle costs the surface of a sphere of its
// volume, (36 pi)^(1/3) sigma dx^2. A quadratic term that ends at the same d adds the energy that the colour
// term lacks.
//
// Forces are the gradient of the sum of E with respect to positions at fixed volumes. The pair force is V_i
// V_j (H (u_i - u_j) + (s_i + s_j) grad W). Here H is the Hessian of W, u = dE/dn, and s = dE/dcolour per
// volume. Momentum, angular momentum and energy are conserved. The kernel is that of surface_kernel.hpp.
//
// Calibration: the lattice's surface has the energy C sigma, of which 0.73 is in the colour term. Packed
// drops (R / dx = 8 and 12) then have Laplace's pressure in their equation of state and the period of the
// second mode. With a smaller share in the colour term, oscillations are too fast at the right pressure. With
// the plain square of o, drops swell by 1 % if the share is one third. They swell by less than 0.2 % if it is
// at least one half. For supports other than 2, C and the share follow from the pressure alone.
//
// Limits: the energy depends on the arrangement of particles. Surface particles form shells, and the energy
// falls to a third of sigma times the area. Disorder inside leaves colour below 1, which causes tension. The
// pressure of all forces is thus about a third of that of the equation of state. It falls as the inside
// becomes ordered (docs/validation/limitations.md). Shells resist like a soft solid: waves are damped two to
// three times as much as by viscosity. Threads in single file, 0.55 spacings apart, have two thirds of a
// cylinder's surface and three times its tension. They form where drops should pinch off.
//
// Walls and solids count as liquid, which gives a contact angle of 90 degrees. They contribute to the colour,
// and attract liquid only through its gradient.
#pragma once
#include "core/math/vec3.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Constants of the surface energy for a scene.
struct SurfaceMeasure {
  double support = 0, spacing = 0;  ///< m, h and dx
  double area = 0, thin = 0;        ///< 1, A and B
  double self = 0, full = 1;  ///< 1, V W of a particle itself, and sum V W of its neighbours on the lattice
  double least = 0, sparse = 0;  ///< 1, d of a single particle, and d below which a neighbourhood is sparse
  double alone = 0;              ///< 1, energy of a single particle beyond the colour term
};
SurfaceMeasure surfaceMeasure(const Numerics& numerics, double spacing);

/// Surface energy per volume (J/m^3) of a particle and its derivatives with respect to gradient and colour
/// (colour not normalised), Pa.
struct SurfaceState {
  double energy = 0;
  Vec3d byGradient{};
  double byColour = 0;
};
SurfaceState surfaceState(const SurfaceMeasure& measure, double tension, const Vec3d& gradient,
                          double colour);

/// h grad W and W (h^-3) at x (in units of h) relative to the other particle.
struct SurfaceKernelValue {
  Vec3d gradient{};
  double colour = 0;
};
SurfaceKernelValue surfaceKernelAt(const Vec3d& x);

/// Contribution of a flat wall to the colour at a distance (h), with its first and second derivative. As in
/// the wall tables, the first layer lies half a spacing below the surface. Further layers follow at
/// distances of one spacing. Each layer is averaged over its plane.
struct WallColour {
  double colour = 0, slope = 0, bend = 0;
};
WallColour wallColour(double spacing, double distance);

}  // namespace thaw
