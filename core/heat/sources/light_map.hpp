// SPDX-License-Identifier: Apache-2.0
// Distribution of light over exposed particles. A ray gives its whole light to the particles near the place
// where it hits the bodies. Its weights are integers, so that sums have the same bits on any number of
// ranks.
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

/// Finds the particles that each ray lights, and the sums of their weights. Requires: findDepths, for the
/// same groups. Collective.
void findWeights(const Continuum& particles, double spacing, LightWork& work, Reducer& all);

/// Returns the fraction of a ray's cell that bodies cover: 1 inside their outline, less on it. The outline of
/// a flat lattice is half a spacing (m) from its outermost particles.
double coverageOf(LightMap& map, const LightView& view, std::size_t cell, double spacing);

/// Returns the weight of a particle for a ray that passes it at a fraction (squared) of shareReach. behind:
/// its depth (m) below the particle that the ray hits first. Returns 0 if another particle hides it.
std::int64_t lightWeight(const LightSource& source, double behind, double fraction2, double spacing);

/// Distance (m) up to which a particle receives light of a ray.
double shareReach(const LightView& view, double depth, double spacing);

}  // namespace thaw
