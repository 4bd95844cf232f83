// Impulse and work of anchors, for the ledger.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// State before a step of dt (s), for bookHeld: call rememberHeld, the step, moveHeld, bookHeld.
struct HeldBefore {
  double dt;
  std::vector<Vec3d> velocity, place, spin;
  std::vector<Quat> turn;
  std::vector<std::uint8_t> flags;  ///< flags before the step, since an anchor may release rows at its end
};
HeldBefore rememberHeld(const World& world, double dt);

/// Records impulse and work of the anchors in the ledger: the change of momentum and energy, less those of
/// all other forces and torques (OrientedWork::acting, actingTorque). Requires: the forces of the step, with
/// Oriented::external scaled by `weight` (see stepOriented).
void bookHeld(World& world, const HeldBefore& before, const OrientedWork& work, double weight);

}  // namespace thaw
