// SPDX-License-Identifier: Apache-2.0
// Gravity. Every integrator adds Domain::gravity, so this term has no force of its own.
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readGravity(KeyTable& keys, Domain& d) {
  keys.restart(Restart::State);
  Vec3d gravity = d.gravity + d.buoyantGravity;  // one of them is 0
  keys.vector("gravity", gravity, "m/s^2", "gravitational acceleration");
  if (!keys.recording()) d.gravity = gravity;
}

}  // namespace

Extension gravityTerm() {
  return {.name = "gravity",
          .about = "uniform acceleration of all particles",
          .model = ModelPart{.domainKeys = readGravity,
                             .limits = {"acceleration"},
                             .energies = {"gravity_J", "gravity_impulse_x_N_s", "gravity_impulse_y_N_s",
                                          "gravity_impulse_z_N_s"}}};
}

}  // namespace thaw
