// SPDX-License-Identifier: Apache-2.0
// Fracture: bonds of elastic solids (core/solid/fracture.hpp), and rigid pieces (core/rigid/breaking/).
#include "core/terms/material_uses.hpp"
#include "core/terms/solid_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readStrength(KeyTable& keys, Material& m) {
  keys.number("break_stretch", m.breakStretch, "", orNever(Range{1, never, true, false, false}),
              "length at which a bond breaks, as a multiple of its rest length; \"never\": no bond breaks");
  keys.number("strength", m.strength, "Pa", orNever(positive()),
              "tensile stress at which rigid pieces (law = \"rigid\") break in an impact. It needs `young`, "
              "which sets the duration of the impact. \"never\": they do not break");
}

void checkStrength(KeyTable& keys, const Material& m, const Numerics&) {
  refuseForRigid(keys, m, {"break_stretch"});
  if (!(m.strength < never)) return;
  if (!m.isRigid())
    keys.fail("strength", "applies to rigid solids only (`law = \"rigid\"`); others break at `break_stretch`",
              {"law"});
  else if (!(m.young.solid > 0))
    keys.fail("strength", "needs `young`, which sets the duration of an impact: set it, too",
              {"young", "law"});
}

std::vector<ModuleUse> usesOfFracture(const Scene& s, const Modules& m) {
  std::vector<ModuleUse> uses = usesBySolids(s, m, &Modules::fracture, {"bonds of ", " break"},
                                             [](const Material& x) { return x.breakStretch < never; });
  append(uses, usesBySolids(s, m, &Modules::breaking, {"", " has a strength"},
                            [](const Material& x) { return x.isRigid() && x.strength < never; }));
  return uses;
}

}  // namespace

Extension fractureTerm() {
  return {.name = "fracture",
          .about = "bonds of elastic solids that break when stretched; rigid pieces that break in impacts",
          .model = ModelPart{
              .materialKeys = readStrength,
              .checkMaterial = checkStrength,
              .modules = {{&Modules::fracture, "fracture"}, {&Modules::breaking, "breaking of rigid pieces"}},
              .uses = usesOfFracture,
              .energies = {"dissipated_J"}}};
}

}  // namespace thaw
