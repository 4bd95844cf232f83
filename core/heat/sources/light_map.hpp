// SPDX-License-Identifier: Apache-2.0
// Distribution of light over exposed particles. All light of a ray goes to the particles near the point where
// the ray hits the bodies. Weights are integers, so sums have the same bits on any number of ranks.
#pragma once
#include <cstddef>
#include <cstdint>

#include "core/halo/halo.hpp"
#include "core/heat/sources/light_work.hpp"
#include "core/particles/continuum.hpp"

namespace thaw {

/// Groups the owned rows by their cells.
void groupRows(const Continuum& particles, LightWork& work);

/// Finds the depths at which the rays of LightWork::views hit particles. Requires: groupRows. Collective.
void findDepths(const Continuum& particles, double spacing, LightWork& work, Reducer& all);

/// Finds the particles that each ray lights, and the sums of their weights. Requires: findDepths for the same
/// groups. Collective.
void findWeights(const Continuum& particles, double spacing, LightWork& work, Reducer& all);

/// Returns the fraction of a ray's cell that bodies cover: 1 inside their outline, less on the outline. The
/// outline of a flat lattice is half a spacing from the outermost particles. spacing: m.
double coverageOf(LightMap& map, const LightView& view, std::size_t cell, double spacing);

/// Returns the weight of a particle for a ray. behind: m, depth of the particle below the one that the ray
/// hits first. fraction2: squared ratio of the distance from the ray to shareReach. Returns 0 if another
/// particle hides it.
std::int64_t lightWeight(const LightSource& source, double behind, double fraction2, double spacing);

/// Returns the distance (m) from a ray up to which a particle receives its light.
double shareReach(const LightView& view, double depth, double spacing);

}  // namespace thaw
