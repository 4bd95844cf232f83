// Particle creation and deletion (ST92): in stretched gaps, at open borders, and where it is crowded.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Is it time to look, in a step of dt? After those whose number is a multiple of OrientedBody::every; not at
/// the start (dt 0).
bool populationDue(const World& world, double dt);

/// Lets particles be born and die, each at most once. Needs ghosts and lists. True where anything changed on
/// any rank: rows are then to be placed again. An offer of a place stands if no other within a spacing has a
/// lower rank, which is a hash of id and step. Births and deaths are in the ledger as what entered and left,
/// with energy 0. A body never has more than OrientedBody::most: of the offers those of the lowest ranks
/// stand. dt (s): of the step that led here, 0 before the start. Collective.
bool changePopulation(World& world, Halos halos, StepTools& tools, double dt);

/// Row i goes: booked, and dropped when rows are placed next.
void letGo(World& world, std::size_t i, double dt);

}  // namespace thaw
