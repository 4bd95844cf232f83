// Films thinner than what holds their surface off its level: their two sides must not pass each other.
#pragma once
#include "core/surface/bins.hpp"
#include "core/surface/surfels.hpp"

namespace thaw {

/// No film is made thinner than this many spacings of the surfels: what its sides have to be apart to be told
/// as two.
inline constexpr double thinnestFilm = 0.4;

/// m, how far surfel i may go into its body when what looks the other way behind it does the same: half of
/// what their distance is over thinnestFilm, below 0 where they are closer than that; infinity where there is
/// no other side within reach. Bins of surfels and ghosts, which may have moved by `slack` (m) since; their
/// places and normals are taken as they are.
double filmRoom(const Surfels& surfels, const Bins& bins, std::size_t i, double spacing, double slack);

}  // namespace thaw
