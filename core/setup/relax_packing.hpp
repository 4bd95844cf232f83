// Packing::Relaxed: particles without the lattice's directions.
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/signed_distance.hpp"
#include "core/step.hpp"

namespace thaw {

/// Moves the particles of bodies with relaxed packing, which start as a jittered lattice, until their kernel
/// gradients balance: steps down the gradient of sum W, held inside the body half a spacing from its surface
/// (as particle shifting does, Lind et al. 2012). Liquid that fills a periodic box has none: it starts
/// anywhere in the lattice's cells and moves through the sides. Liquids away from walls, whose density is a
/// sum over neighbours, then settle, until no filling is above 1 by more than 1e-4: no pressure sets them in
/// motion. Runs over the ranks as a step does, and gives the same bits on any number of them. Particles end
/// on the rank that owns their cell. Returns the number of iterations; 0 where no body asks for it.
/// Collective.
int relaxPacking(World& world, Halos halos, StepTools& tools,
                 const std::vector<std::shared_ptr<const SignedDistance>>& shapes);

}  // namespace thaw
