// What the loops over bonds load of both ends: Solids::end and ElasticWork::motion4.
#pragma once
#include "core/solid/elastic.hpp"

namespace thaw {

/// References of rows [first, last), where bonds have no vectors of their own; after every relink, of those
/// that changed.
void packReferences(const ElasticWork& work, Solids& solids, std::size_t first, std::size_t last);

/// Displacements (or places) of rows [first, last).
void packPlaces(const ElasticWork& work, Solids& solids, std::size_t first, std::size_t last);

/// Velocities and drag of rows [first, last), where bonds are damped; after phase 1.
void packMotion(ElasticWork& work, const Solids& solids, std::size_t first, std::size_t last);

}  // namespace thaw
