// SPDX-License-Identifier: Apache-2.0
// Welding: new bonds between solids, and rigid pieces that join (core/rigid/welding/).
#include <charconv>

#include "core/terms/material_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readWelding(KeyTable& keys, Material& m) {
  keys.flag("weld", m.weld, "solids of this material that touch after freezing weld together");
  keys.number(
      "weld_temperature", m.weldTemperature, "K", orNever(positive()),
      "rigid pieces (law = \"rigid\") of this material join where their surfaces touch and both are hotter "
      "than this. Fractures weld only after they have cooled. \"never\": no piece welds");
  keys.number(
      "weld_time", m.weldTime, "s", notNegative(),
      "time for which hot surfaces must touch until they weld at `weld_temperature`. 0: pieces stick as "
      "they touch, so they do not rebound");
}

void checkWelding(KeyTable& keys, const Material& m, const Numerics&) {
  if (m.isRigid() && keys.has("weld"))
    keys.fail("weld",
              "has no effect with `law = \"rigid\"`: rigid pieces weld at `weld_temperature`; remove "
              "`weld`, or choose another law");
  if (m.weldTemperature < never && !m.isRigid())
    keys.fail("weld_temperature",
              "applies to rigid solids only (`law = \"rigid\"`); others weld with `weld = true`", {"law"});
  if (m.weldTemperature < never && m.melts() && m.weldTemperature >= m.liquidus) {
    char digits[40];
    char* const end = std::to_chars(digits, digits + sizeof digits, m.liquidus).ptr;
    keys.fail("weld_temperature",
              "the material melts at " + std::string(digits, end) +
                  " K, before its pieces weld: expected a lower temperature",
              {"melts"});
  }
  if (m.weldTime > 0 && !(m.weldTemperature < never))
    keys.fail("weld_time", "applies only with `weld_temperature`: set it, too", {"weld_temperature"});
}

std::vector<ModuleUse> heatOfWelding(const Scene& s) {
  return usesByMaterials(s, &Modules::heat, {"pieces of ", " weld where they are hot"},
                         [](const Material& m) { return m.weldTemperature < never; });
}

std::vector<ModuleUse> usesOfWelding(const Scene& s, const Modules& m) {
  std::vector<ModuleUse> uses = usesBySolids(
      s, m, &Modules::pieceWelding, {"", " has a `weld_temperature`"},
      [](const Material& x) { return x.isRigid() && x.weldTemperature < never; });
  if (m.contact)
    append(uses, usesBySolids(s, m, &Modules::welding, {"solids of ", " grow together"},
                              [](const Material& x) { return x.weld; }));
  return uses;
}

}  // namespace

Extension weldingTerm() {
  return {.name = "welding",
          .about = "separate solids that touch grow together",
          .model = ModelPart{.materialKeys = readWelding,
                             .checkMaterial = checkWelding,
                             .modules = {{&Modules::welding, "welding"},
                                         {&Modules::pieceWelding, "welding of rigid pieces"}},
                             .earlyUses = heatOfWelding,
                             .uses = usesOfWelding,
                             .energies = {"dissipated_J"}}};
}

}  // namespace thaw
