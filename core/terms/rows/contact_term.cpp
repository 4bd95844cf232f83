// SPDX-License-Identifier: Apache-2.0
// Contact and friction of separate solids (core/contact/, core/rigid/contact/).
#include "core/terms/material_uses.hpp"
#include "core/terms/solid_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readSelfContact(KeyTable& keys, Numerics& n) {
  keys.restart(Restart::Coefficient);
  keys.flag("self_contact", n.selfContact, "pieces of one body collide with each other");
}

void readContact(KeyTable& keys, Material& m) {
  keys.number(
      "friction", m.friction, "", between(0, 10),
      "Coulomb friction between separate solids: the smaller of the two applies. At an obstacle, that "
      "of the obstacle applies");
  keys.number(
      "rolling_friction", m.rollingFriction, "m", notNegative(),
      "largest moment against rolling and spinning at a contact of a rigid piece (law = \"rigid\"), over "
      "the normal force; about 0.01 to 0.1 of the radius of rough stones. Between two pieces the larger "
      "one applies");
  keys.number("restitution", m.restitution, "", between(0, 1),
              "restitution of contacts between separate solids and with obstacles: the smaller of the two "
              "applies, so set both for a value above 0.5");
}

void checkContact(KeyTable& keys, const Material& m, const Numerics&) {
  if (keys.has("rolling_friction") && !m.isRigid())
    keys.fail("rolling_friction", "applies to rigid solids only: set `law = \"rigid\"`, or remove it",
              {"law"});
}

std::vector<ModuleUse> usesOfContact(const Scene& s, const Modules& m) {
  if (!m.solid) return {};
  std::vector<ModuleUse> uses;
  if (solidBodies(s) > 1) uses.push_back({&Modules::contact, "there are several solid bodies"});
  if (m.freezing) uses.push_back({&Modules::contact, "frozen pieces can touch"});
  if (m.fracture && s.numerics.selfContact) uses.push_back({&Modules::contact, "pieces can touch"});
  if (!uses.empty() && m.elastic && s.bodies.size() + s.emitters.size() > 1)
    uses.push_back({&Modules::bodyContact, "solids of different bodies can touch"});
  append(uses, usesBySolids(s, m, &Modules::rollingFriction, {"", " has a `rolling_friction`"},
                            [](const Material& x) { return x.isRigid() && x.rollingFriction > 0; }));
  return uses;
}

}  // namespace

Extension contactTerm() {
  return {.name = "contact of solids",
          .about = "separate solids repel each other where they touch, with friction and restitution",
          .model = ModelPart{.numericsKeys = readSelfContact,
                             .materialKeys = readContact,
                             .checkMaterial = checkContact,
                             .modules = {{&Modules::contact, "contact of solids"},
                                         {&Modules::bodyContact, "contact of bodies"},
                                         {&Modules::rollingFriction, "rolling friction"}},
                             .uses = usesOfContact,
                             .limits = {"contact"},
                             .energies = {"contact_J", "dissipated_J"}}};
}

}  // namespace thaw
