// What anchors give and take, for the books.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Held rows before a step of dt (s); then the step, then moveHeld, then bookHeld.
struct HeldBefore {
  double dt;
  std::vector<Vec3d> velocity, place, spin;
  std::vector<Quat> turn;
  std::vector<std::uint8_t> flags;  ///< an anchor may let go at the end of the step that it still held
};
HeldBefore rememberHeld(const World& world, double dt);

/// Impulse and work of the anchors into the ledger: change of momentum and energy less what the other forces
/// and torques of the step (OrientedWork::acting, actingTorque) do. Needs the forces of the step,
/// Oriented::external among them with the weight of the step (`weight`: see stepOriented).
void bookHeld(World& world, const HeldBefore& before, const OrientedWork& work, double weight);

}  // namespace thaw
