// SPDX-License-Identifier: Apache-2.0
// Substeps of solids (r-RESPA, TBM92 eq. 2.22). With substeps, a stiff solid does not limit the step of all
// particles. Fast forces are those of bonds, and of contacts of solids with walls, which are as stiff as the
// solid. All other forces are slow. In a step of dt with n substeps, d = dt / n:
//   v += slow dt/2 + fast d/2;
//   n times: x += v d, then (except for the last) fast forces at the new positions, v += fast d;
//   all forces;
//   v += slow dt/2 + fast d/2.
// The last of the n evaluations is that of the step (evaluate). n = 1 is plain leap-frog. Substeps do not
// sort or search particles. Plastic flow and bond damping act in every substep, over d. Fracture, bond
// forming, melting and new references happen once per step. Contacts between solids need neighbours, so they
// are slow forces, and limit dt (Limit::Contact) if they exist.
#pragma once
#include "core/halo/halos.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Advances all particles that take substeps to the end of the step. Call it after kickAndDrift, which
/// applied only the first kick of these particles. Velocities are those before the last kick. A particle that
/// would cross its support radius in dt gets a non-finite velocity, which finishKick detects. Does nothing if
/// the clock has one substep. Collective.
void substepSolids(World& world, Halos halos, StepTools& tools, double dt);

/// Sets the number of substeps of the next step (Clock::dt) such that no substep is longer than `longest`
/// (s). Adjusts the part of fast forces in Ledger::wallForce.
void chooseSubsteps(const Modules& modules, Clock& clock, Ledger& ledger, const WallContacts& contacts,
                    double longest);

}  // namespace thaw
