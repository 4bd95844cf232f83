// Several steps of the solids within one of the scene, so that a stiff solid does not set everyone's step:
// r-RESPA (Tuckerman, Berne & Martyna 1992, "Reversible multiple time scale molecular dynamics", eq. 2.22).
// Fast are the forces of bonds, and what walls do to solids by contact, as stiff as the solid; slow is all
// else. In a step of dt with n substeps, d = dt / n:
//   v += slow dt/2 + fast d/2;  n times: x += v d, then (but for the last) fast forces at the new places, v
//   += fast d; all forces;  v += slow dt/2 + fast d/2
// so the last of the n evaluations is the step's own (evaluate). With n = 1 it is the plain leap-frog. Within
// a step nothing is sorted or searched: the inner steps touch bonds only. Plastic flow and bond damping act
// in every substep over d; breaking, forming, melting and new references once a step. Contacts between solids
// need neighbours: they are slow, and bound dt (Limit::Contact) where there are any.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// From the last forces to the places at the end of the step for all that takes substeps; after kickAndDrift,
/// which gave it its first kick only. Velocities are those before the last kick. A particle that would pass
/// its support radius in dt gets a velocity that is not finite, for finishKick to find. Collective; does
/// nothing where the clock has one substep.
void substepSolids(World& world, Halos halos, StepTools& tools, double dt);

/// Substeps of the next step, of Clock::dt, none longer than `longest` (s), into the clock. The share of fast
/// forces in Ledger::wallForce follows.
void chooseSubsteps(World& world, const StepTools& tools, double longest);

}  // namespace thaw
