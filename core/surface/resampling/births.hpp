// SPDX-License-Identifier: Apache-2.0
// New surfels next to existing ones.
#pragma once
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/surface/search/local_surface.hpp"

namespace thaw {

/// Values of one surfel outside of the table.
struct SurfelRow {
  std::uint64_t id = 0, component = noComponent;
  Vec3d position{}, normal{0, 0, 1}, tangent{1, 0, 0};  ///< m, unit, unit
  double radius = 0;                                    ///< m
  std::uint32_t colour = 0;
  float detail = 0, liquid = 0, temperature = 0, maxLiquidFraction = 0, detailHeight = 0;  ///< units as in
                                                                                           ///< Surfels
  bool hasReference = false;  ///< has a reference position and frame (reference_motion.hpp)
  Vec3d referencePosition{}, referenceNormal{}, referenceTangent{};  ///< m, unit, unit
  static constexpr std::uint32_t none = 0xffffffffu;
  std::uint32_t particle = none;  ///< row of the particle copy that it grows from; none: born between surfels
};

/// Returns a surfel at p with values interpolated from the patch. Weights vanish at 1.5 radii. The caller
/// sets its id.
SurfelRow blendedSurfel(const Patch& patch, const SurfacePoint& p);

/// Appends rows behind the owned ones without a check of ids (see addSurfels). Requires: no ghosts.
void appendSurfels(Surfels& surfels, const std::vector<SurfelRow>& rows);

/// Appends births on all ranks. Ids that exist already in the table or in `others` are replaced
/// (makeIdsUnique). Collective.
void addSurfels(Surfels& surfels, const std::vector<SurfelRow>& rows, std::uint64_t seed, Reducer& all,
                const Surfels* others = nullptr);

}  // namespace thaw
