// SPDX-License-Identifier: Apache-2.0
// Loads on rigid parts of elastic solids, from liquids, sheets, oriented particles and external forces.
#pragma once
#include "core/rigid/rigidify/rigidify_view.hpp"

namespace thaw {

/// Sets Continuum::restTime of passive particles to 0 if their load has changed too much since they became
/// passive. The limit (N) is the strain numerics.rigidify * numerics.sleep_after times Young's modulus times
/// the area of a particle. Continuum::constraintForce stores the load (N) in the body frame. Requires: all
/// forces of the evaluation. For passive particles, they consist of loads only.
void compareLoads(const RigidifyView& view);

}  // namespace thaw
