// SPDX-License-Identifier: Apache-2.0
// Ledger entries of a row of any body type except the continuum.
#pragma once
#include "core/ledger/ledger.hpp"
#include "core/particles/body_type_rows.hpp"

namespace thaw {

/// Rotation of a row about its centre.
struct RowRotation {
  Vec3d angularMomentum{};  ///< kg m^2/s
  double energy = 0;        ///< J
};

/// Adds row i to a balance: mass, momentum, kinetic energy with rotation, potential energy of gravity
/// (m/s^2), and BodyTypeRows::energy as elastic energy.
void addBodyTypeRow(const BodyTypeRows& rows, std::size_t i, const RowRotation& rotation,
                    const Vec3d& gravity, ExactBalance& balance);

}  // namespace thaw
