// SPDX-License-Identifier: Apache-2.0
// Plastic flow of elastic solids (core/solid/laws/plasticity.hpp).
#include "core/terms/material_uses.hpp"
#include "core/terms/solid_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readReference(KeyTable& keys, Numerics& n) {
  keys.restart(Restart::Setting);
  keys.number("plastic_rereference", n.plasticRereference, "", positive(),
              "norm of the plastic strain above which the reference follows the flow");
}

void readPlasticity(KeyTable& keys, Material& m) {
  keys.blend(
      {"yield_strain", "", orNever(positive()), LiquidValue::Same,
       "yield stress as a strain (gamma_yield). The material flows if the norm of the deviatoric stress "
       "exceeds 2 G gamma_yield, a uniaxial stress of sqrt(6) G gamma_yield. \"never\": no plasticity"},
      m.yieldStrain);
  keys.blend({"creep_rate", "1/s", orNever(notNegative()), LiquidValue::Same,
              "rate at which stress above the yield stress decays at a fixed deformation (gamma_creep); its "
              "viscosity is G / `creep_rate`; \"never\": at once"},
             m.creepRate);
  keys.number("hardening", m.hardening, "Pa", notNegative(),
              "growth of the uniaxial yield stress with the equivalent plastic strain; 0: none");
  keys.number("max_plastic_strain", m.maxPlasticStrain, "", orNever(positive()),
              "largest norm of the logarithmic plastic strain (gamma_max), beyond which the material is "
              "elastic; \"never\": no limit");
}

bool yieldsAtAll(const Material& m) { return m.yieldStrain.solid < never || m.yieldStrain.liquid < never; }

void checkPlasticity(KeyTable& keys, const Material& m, const Numerics&) {
  refuseForRigid(keys, m, {"yield_strain", "creep_rate", "hardening", "max_plastic_strain"});
  if (yieldsAtAll(m) && !m.canBeSolid())
    keys.fail("yield_strain", "requires a solid: set `young`, or remove `yield_strain`", {"young"});
  if (keys.has("creep_rate") && !keys.has("yield_strain"))
    keys.fail("creep_rate", "only a material that yields creeps: set `yield_strain`, too");
  if (m.hardening > 0 && !keys.has("yield_strain"))
    keys.fail("hardening", "needs `yield_strain`: only a material that yields can harden");
}

std::vector<ModuleUse> usesOfPlasticity(const Scene& s, const Modules& m) {
  return usesBySolids(s, m, &Modules::plastic, {"", " yields"}, yieldsAtAll);
}

}  // namespace

Extension plasticityTerm() {
  return {.name = "plasticity",
          .about = "permanent deformation of solids above their yield stress",
          .model = ModelPart{.numericsKeys = readReference,
                             .materialKeys = readPlasticity,
                             .checkMaterial = checkPlasticity,
                             .modules = {{&Modules::plastic, "plastic flow"}},
                             .uses = usesOfPlasticity,
                             .energies = {"dissipated_J"}}};
}

}  // namespace thaw
