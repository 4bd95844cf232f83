// SPDX-License-Identifier: Apache-2.0
// Heat of lamps, lasers and heated regions (docs/theory/heat_sources.md).
#pragma once
#include "core/halo/halo.hpp"
#include "core/heat/heat_view.hpp"
#include "core/heat/sources/light_work.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

struct HeatSourceView {
  HeatView heat;
  const Walls& walls;  ///< at their places at the end of the step
  LightWork& work;
};

/// Returns the owned rows of the particles that a region at this pose heats.
std::vector<std::uint32_t> rowsInRegion(const HeatedRegion& region, const SignedDistance& shape,
                                        const Pose& pose, const Continuum& particles);

/// Adds the power of the scene's sources to heatFlow for the step of length dt (s) that begins now, by
/// positions at its end. Moving sources are where they are in the middle of the step. Sets
/// Continuum::absorbed; records the energies in Ledger::lamps, lasers, regions and sourceUse, and in heatIn.
/// dt = 0: at the start, for frames. Requires: Modules::lamps. Collective.
void addHeatSources(const HeatSourceView& view, double dt, Reducer& all);

/// Largest step (s) for moving sources at this time (s): none moves farther than half of its beam's radius,
/// or half a spacing.
double sourceStepLimit(const Scene& scene, double time);

}  // namespace thaw
