// SPDX-License-Identifier: Apache-2.0
// Loads on rigid parts of elastic solids, from liquids, sheets, oriented particles and outside forces.
#pragma once
#include "core/rigid/rigidify/rigidify_view.hpp"

namespace thaw {

/// Sets Continuum::restTime of passive particles to 0 if their load has changed too much since they became
/// passive. The limit is the strain numerics.rigidify * numerics.sleep_after times Young's modulus and the
/// area of a particle. Continuum::constraintForce keeps the load in the body frame. Requires: all forces of
/// the evaluation, which are loads alone for passive particles.
void compareLoads(const RigidifyView& view);

}  // namespace thaw
