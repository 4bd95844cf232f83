// SPDX-License-Identifier: Apache-2.0
// Packing::Relaxed: a packing of particles without the directions of a lattice.
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/halo/halos.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Relaxes the particles of bodies with relaxed packing, which start as a jittered lattice, until their
/// kernel gradients balance. Steps follow the negative gradient of sum W within the body, half a spacing from
/// its surface (as in particle shifting, LXSR12). Liquid that fills a periodic box has no surface. Its
/// particles start anywhere in the lattice's cells and may move through the sides. Liquids with summed
/// density that do not touch walls are then relaxed further, until no relative density exceeds 1 by more than
/// 1e-4. Pressure thus does not set these liquids in motion. The bits are the same on any number of ranks.
/// Particles end on the rank that owns their cell. Returns the number of iterations; 0 if no body requests
/// it. Collective.
int relaxPacking(World& world, Halos halos, StepTools& tools,
                 const std::vector<std::shared_ptr<const SignedDistance>>& shapes);

}  // namespace thaw
