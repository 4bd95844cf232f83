// Energy that liquid with surface tension takes along through open sides. Surface tension and compression are energies of neighbourhoods:
// the neighbours of a particle that leaves get a new surface and a lower density, and their energy changes with it.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/world.hpp"

namespace thaw {

struct StepTools;

/// A particle that leaves in this step.
struct Leaver {
  std::uint64_t id = 0;
  Vec3d position{};        ///< m
  double volume = 0;       ///< h^3
  double rootTension = 0;  ///< (N/m)^1/2
};

/// Leavers of all ranks, ascending by id. Collective.
std::vector<Leaver> leaversOfAll(const World& world, const StepTools& tools, Reducer& all);

/// Adds to Ledger::left the energy that owned liquid particles lose with StepTools::leavers; negative where they gain it.
/// Requires: cells, places, densities and surface sums of the particles that stay, all of now.
void recordEnergyLeft(World& world, const StepTools& tools);

}  // namespace thaw
