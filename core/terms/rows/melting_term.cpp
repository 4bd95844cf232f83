// SPDX-License-Identifier: Apache-2.0
// Melting and freezing (core/solid/melting.hpp). find_modules.cpp determines which phases a scene can have,
// and thus whether a material melts.
#include "core/scene/phase_density.hpp"
#include "core/terms/material_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readLatentHeat(KeyTable& keys, Material& m) {
  keys.number("latent_heat", m.latentHeat, "J/kg", notNegative(), "latent heat of melting");
  keys.number("hysteresis", m.hysteresis, "", Range{0, 0.5, false, true, false},
              "liquid freezes at or below this liquid fraction, solid melts at or above 1 minus it");
}

void checkMelting(KeyTable& keys, const Material& m, const Numerics&) {
  if (m.latentHeat > 0 && !keys.has("melts"))
    keys.fail("latent_heat", "only a material that melts has a latent heat: set `melts`, too");
  if (keys.has("hysteresis") && !keys.has("melts"))
    keys.fail("hysteresis", "only a material that melts has hysteresis: set `melts`, too");
}

std::vector<ModuleUse> usesOfMelting(const Scene& s, const Modules& m) {
  std::vector<ModuleUse> uses = usesBySolids(
      s, m, &Modules::phaseDensity, {"solid and liquid of ", " differ in density"}, hasPhaseDensities);
  append(uses, usesBySolids(s, m, &Modules::freezing, {"", " can freeze again"},
                            [&](const Material& x) { return x.melts() && m.melting; }));
  return uses;
}

}  // namespace

Extension meltingTerm() {
  return {.name = "melting",
          .about = "solids that melt and liquids that freeze, with their latent heat and change of density",
          .heats = true,
          .model = ModelPart{.materialKeys = readLatentHeat,
                             .checkMaterial = checkMelting,
                             .modules = {{&Modules::melting, "melting"},
                                         {&Modules::freezing, "freezing"},
                                         {&Modules::phaseDensity, "density by phase"}},
                             .uses = usesOfMelting,
                             .energies = {"internal_J", "phase_jump_J"}}};
}

}  // namespace thaw
