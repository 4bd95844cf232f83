// SPDX-License-Identifier: Apache-2.0
// Heat of lamps, lasers and heated regions (docs/theory/heat_sources.md).
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/halo/halo.hpp"
#include "core/heat/heat_view.hpp"
#include "core/heat/sources/light_work.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

struct LightTarget {
  HeatView heat;
  const Walls& walls;  ///< at their positions at the end of the step
  LightWork& work;
};

/// Returns the owned rows of the particles that a region at this pose heats.
std::vector<std::uint32_t> rowsInRegion(const HeatedRegion& region, const SignedDistance& shape,
                                        const Pose& pose, const Continuum& particles);

/// Adds the absorbed light of lamps and lasers to heatFlow and Continuum::absorbed, for the step of dt
/// (s) that begins now. Particles are at their positions at the end of the step, moving sources at those in
/// its middle. Records the energies in Ledger::lamps, lasers, sourceUse and heatIn. dt = 0: at the start, for
/// frames. Requires: Modules::lamps. Collective.
void addLight(const LightTarget& target, double dt, Reducer& all);

/// Does the same for heated regions, with Ledger::regions and sourceUse. shapes: shapes of
/// Scene::heatedRegions.
void addRegionHeat(const HeatView& view, const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                   double dt, Reducer& all);

/// Returns the largest step (s) for moving lamps and lasers from this time (s). A lamp moves at most half a
/// spacing. A laser moves at most half a spacing or half its beam's radius, whichever is larger.
double lightStepLimit(const Scene& scene, double time);
/// Does the same for heated regions.
double regionStepLimit(const Scene& scene, double time);

}  // namespace thaw
