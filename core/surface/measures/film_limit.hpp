// SPDX-License-Identifier: Apache-2.0
// Limits inward offsets on thin films, so their two sides do not pass through each other.
#pragma once
#include "core/surface/data/surfels.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Smallest thickness of a film, in spacings of surfels, at which its two sides remain distinct.
inline constexpr double thinnestFilm = 0.4;

/// Returns the largest inward offset (m) of surfel i if the opposite side moves by the same offset. It is
/// half the excess of their distance over thinnestFilm. It is negative if the sides are closer, and infinity
/// without an opposite side. bins: surfels and ghosts, which may since have moved by `slack` (m). Positions
/// and normals are current.
double filmOffsetLimit(const Surfels& surfels, const Bins& bins, std::size_t i, double spacing, double slack);

}  // namespace thaw
