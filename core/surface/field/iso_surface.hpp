// SPDX-License-Identifier: Apache-2.0
// Projection onto the iso-surface of the particles' colour field.
#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "core/surface/field/field_probe.hpp"
#include "core/surface/search/local_surface.hpp"

namespace thaw {

/// Newton's step onto the iso-surface, or onto an offset of `isoOffset` (m) from it. It has the outward unit
/// direction, and the distance along it (m, clamped to `longest`). isoStep returns nothing if the gradient is
/// too small.
struct IsoStep {
  Vec3d outward{};
  double out = 0;
};
std::optional<IsoStep> isoStep(const FieldSample& field, double particleSupport, double isoOffset,
                               double longest);

/// Where to look for an iso-surface.
struct IsoTarget {
  std::uint64_t component;
  Vec3d ownPosition;  ///< m, see FieldProbe::around
  double farthest;    ///< m, largest distance of the surface from a position
};

/// Projects n <= FieldProbe::most positions along the gradient onto a component's iso-surface and returns
/// points and normals. Positions without a surface within `farthest` (m) give nothing. ownPosition: see
/// FieldProbe::around. Changes the particles selected in the probe.
void projectToIsoSurface(FieldProbe& probe, const IsoTarget& target, std::span<const Vec3d> from,
                         std::optional<SurfacePoint>* found);

}  // namespace thaw
