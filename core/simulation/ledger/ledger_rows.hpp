// SPDX-License-Identifier: Apache-2.0
// Ledger entries for rows of oriented and sheet bodies.
#pragma once
#include "core/ledger/ledger.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Adds row i of a body type (core/simulation/world/body_types.hpp) to a balance: mass, momentum, kinetic
/// energy with rotation, gravitational potential, and BodyTypeRows::energy as elastic energy.
void addBodyTypeRow(const World& world, std::size_t type, std::size_t i, ExactBalance& balance);

}  // namespace thaw
