// The surface of the particles' colour field, away from surfels.
#pragma once
#include <optional>

#include "core/surface/field_probe.hpp"
#include "core/surface/local_surface.hpp"

namespace thaw {

/// Newton's step from a place with this field onto the surface, or to `raised` (m) off it: the way out of the
/// body there, and how far along it (m, at most `longest` to either side). None where there is no surface to
/// be seen.
struct IsoStep {
  Vec3d outward{};
  double out = 0;
};
std::optional<IsoStep> isoStep(const FieldHere& field, double particleSupport, double raised, double longest);

/// The points of a component's surface that are reached from n <= FieldProbe::most places along the gradient,
/// and the normals there; none where there is none within `farthest` (m) of the place. home:
/// FieldProbe::around. Changes what the probe looks at.
void ontoIsoSurface(const World& world, FieldProbe& probe, std::uint64_t component, const Vec3d& home,
                    const Vec3d* from, std::size_t n, double farthest, std::optional<SurfacePoint>* found);

}  // namespace thaw
