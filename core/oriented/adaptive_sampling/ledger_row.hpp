// SPDX-License-Identifier: Apache-2.0
// Ledger entries of oriented particles.
#pragma once
#include "core/ledger/ledger.hpp"
#include "core/oriented/data/oriented.hpp"

namespace thaw {

/// Adds row i to a balance: mass, momentum, kinetic energy including rotation, potential energy, and
/// BodyTypeRows::energy as elastic energy. gravity: m/s^2.
void addOrientedRow(const Oriented& rows, std::size_t i, const Vec3d& gravity, ExactBalance& balance);

}  // namespace thaw
