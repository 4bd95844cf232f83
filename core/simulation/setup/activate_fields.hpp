// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/simulation/world/world.hpp"
#include "core/solid/elasticity/elastic.hpp"
#include "core/terms/term_work.hpp"

namespace thaw {

/// Activates the fields of particles and solids that the scene's modules need.
void activateFields(World& world, const TermWork& terms, ElasticWork& elastic);

}  // namespace thaw
