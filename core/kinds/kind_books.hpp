// Rows of the further kinds in the ledger.
#pragma once
#include "core/ledger/ledger.hpp"
#include "core/world.hpp"

namespace thaw {

/// Adds row i of a kind (core/kinds/kinds.hpp) to a balance: mass, momentum, kinetic energy, that of rotation
/// too, gravity's potential, and KindRows::energy as elastic energy.
void addKindRow(const World& world, std::size_t kind, std::size_t i, ExactBalance& balance);

}  // namespace thaw
