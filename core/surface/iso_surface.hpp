// The surface of the particles' colour field, away from surfels.
#pragma once
#include "core/surface/local_surface.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

/// The colour field of one component at a place (the sum of readyParticles, 1 deep inside), and what it is on the surface (LevelTable).
struct FieldHere { double value = 0, level = 0.5, tight = 1; Vec3d gradient{}; };  ///< 1, 1, 1: share of Newton's step, 1/m
FieldHere colourAt(const World& world, const SurfaceTools& tools, std::uint64_t component, const Vec3d& x);

/// The point of a component's surface that is reached from x along the gradient, and the normal there. False where there is none within
/// `most` (m). Both need readyParticles.
bool ontoIsoSurface(const World& world, const SurfaceTools& tools, std::uint64_t component, const Vec3d& x, double most, SurfacePoint& found);

}  // namespace thaw
