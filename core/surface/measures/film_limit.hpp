// SPDX-License-Identifier: Apache-2.0
// Limits inward offsets on thin films, so that their two sides do not pass each other.
#pragma once
#include "core/surface/data/surfels.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Least thickness of a film in spacings of surfels, at which its two sides remain distinct.
inline constexpr double thinnestFilm = 0.4;

/// Returns the largest inward offset (m) of surfel i if the opposite side moves equally: half the excess of
/// their distance over thinnestFilm. It is negative if they are closer, and infinity without an opposite
/// side. Bins hold surfels and ghosts, which may have moved by `slack` (m) since; positions and normals are
/// current.
double filmOffsetLimit(const Surfels& surfels, const Bins& bins, std::size_t i, double spacing, double slack);

}  // namespace thaw
