// SPDX-License-Identifier: Apache-2.0
// Drag of mushes (core/heat/mush.hpp). Its integration is exact, so it does not limit the step.
#include "core/terms/material_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readDrag(KeyTable& keys, Material& m) {
  keys.number("mush_drag", m.mushDrag, "kg/(m^3 s)", notNegative(),
              "coefficient C of the drag C (1 - f)^2 / (f^3 + 0.001) of solid neighbours on the liquid. It "
              "acts while the liquid fraction f is below 1. 0: none");
}

void checkDrag(KeyTable& keys, const Material&, const Numerics&) {
  if (keys.has("mush_drag") && !keys.has("melts"))
    keys.fail("mush_drag", "has no effect without `melts`; set both");
}

std::vector<ModuleUse> usesOfDrag(const Scene& s, const Modules& m) {
  if (!m.melting) return {};
  return usesByMaterials(s, &Modules::mushDrag,
                         {"", " slows its liquid beside solids between solidus and liquidus"},
                         [&](const Material& x) { return inUse(s, x) && x.melts() && x.mushDrag > 0; });
}

}  // namespace

Extension mushTerm() {
  return {.name = "mush drag",
          .about = "drag of solid neighbours on liquid that is about to freeze",
          .heats = true,
          .model = ModelPart{.materialKeys = readDrag,
                             .checkMaterial = checkDrag,
                             .modules = {{&Modules::mushDrag, "mush drag"}},
                             .uses = usesOfDrag,
                             .energies = {"dissipated_J"}}};
}

}  // namespace thaw
