// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include "core/materials/liquid_materials.hpp"
#include "core/scene/buoyancy.hpp"
#include "core/scene/phase_density.hpp"
#include "core/scene/quality.hpp"
#include "core/scene/temperature_table.hpp"
#include "io/scene/tables/read_extension.hpp"
#include "io/scene/tables/read_flow_law.hpp"
#include "io/scene/tables/read_heat_exchange.hpp"
#include "io/scene/tables/read_sections.hpp"
#include "io/scene/text/value_text.hpp"

namespace thaw {

bool readColour(const std::string& text, std::uint32_t& colour) {
  if (text.size() != 7 || text[0] != '#' ||
      text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
    return false;
  const unsigned long rgb = std::strtoul(text.c_str() + 1, nullptr, 16);
  colour = static_cast<std::uint32_t>((rgb >> 16 & 255) | (rgb & 0xff00) | (rgb & 255) << 16);
  return true;
}

void readColourKey(TableReader& r, std::uint32_t& colour, const char* about) {
  std::string text;
  r.as(Restart::Free).text("colour", text, about, "\"#rrggbb\"");
  if (!text.empty() && !readColour(text, colour))
    r.refuseValue("colour", "expected six hexadecimal digits such as \"#e8c890\"");
}

namespace {

using Liquid = TableReader::Liquid;
constexpr const char* meltsRange = "> 0, one temperature or [solidus, liquidus]";

/// Reads one density at rest, or those of solid and liquid. A table must have both.
void readDensityAtRest(TableReader& r, Material& m) {
  const bool byPhase = r.reading() && r.isTable("density");
  Blend density = byPhase ? Blend{} : Blend{solidDensityOf(m), m.density};
  r.orAs(KeyForm::Type::Pairs)
      .blend({"density", "kg/m^3", positive(), Liquid::Same,
              "density at rest. One value: that of solid and liquid. Two values: those of solid and liquid, "
              "where the material melts. Volumes then change as particles melt and freeze, and masses do "
              "not. Table: density of the liquid by temperature for its buoyancy, `[[\"0 degC\", \"999.84 "
              "kg/m^3\"], [\"4 degC\", \"999.97 kg/m^3\"]]`, interpolated linearly. The density at rest is "
              "then its value at `expansion_from`"},
             density);
  if (byPhase && (density.solid == 0 || density.liquid == 0))
    return r.fail("density", "expected the densities of both phases, { solid = ..., liquid = ... }");
  m.density = density.liquid;
  m.solidDensity = density.solid == density.liquid ? 0 : density.solid;
}

void readDensity(TableReader& r, Material& m) {
  if (r.hasList("density") || !m.densityTable.empty())
    r.pairs({"density", "K", "kg/m^3", {0, never, true, false, false}, positive(), "", ""}, m.densityTable);
  else readDensityAtRest(r, m);
}

void readLiquid(TableReader& r, Material& m) {
  readDensity(r, m);
  if (r.hasList("viscosity") || !m.viscosityTable.empty()) {
    r.pairs({"viscosity", "K", "Pa s", {0, never, true, false, false}, positive(), "", ""}, m.viscosityTable);
  } else {
    r.orAs(KeyForm::Type::Pairs)
        .blend(
            {"viscosity", "Pa s", notNegative(), Liquid::Same,
             "viscosity of the liquid; or a table of pairs `[[\"900 degC\", \"1e4 Pa s\"], [\"1200 degC\", "
             "\"50 Pa s\"]]`, interpolated logarithmically"},
            m.viscosity);
  }
  readColourKey(r, m.colour,
                "colour of its surface in pictures and exports, if its mesh has none; default: a pale one");
  readTermKeys(r, m, false);
  r.number(
      "sound_speed", m.soundSpeed, "m/s", notNegative(),
      "speed of sound of the equation of state; 0: from the largest expected speed and `max_density_error`");
  r.byScene().number(
      "bulk_damping", m.bulkDamping, "", between(0, 0.05),
      "damping of sound in liquids with `density = \"continuity\"`. The pressure is taken at the density "
      "extrapolated by the time h / `sound_speed` times this number, with the support radius h. Default: "
      "0.02 where a default of `artificial_viscosity` applies, else 0");
}

void readSolid(TableReader& r, Material& m) {
  Blend young = m.impactModulus > 0 ? Blend{m.impactModulus, 0} : m.young;
  r.blend({"young", "Pa", notNegative(), Liquid::Unchanged,
           "Young's modulus; above 0 the material can be solid. A single value is for the solid, and the "
           "liquid has 0"},
          young);
  if (r.reading()) m.young = young;
  r.blend({"poisson", "", inside(-1, 0.5), Liquid::Same, "Poisson's ratio"}, m.poisson);
  readLaw(r, m);
  r.blend({"yield_strain", "", orNever(positive()), Liquid::Same,
           "yield stress as a strain (gamma_yield). The material flows if the norm of the deviatoric stress "
           "exceeds 2 G gamma_yield, a uniaxial stress of sqrt(6) G gamma_yield. \"never\": no plasticity"},
          m.yieldStrain);
  r.blend({"creep_rate", "1/s", orNever(notNegative()), Liquid::Same,
           "rate at which stress above the yield stress decays at a fixed deformation (gamma_creep); its "
           "viscosity is G / `creep_rate`; \"never\": at once"},
          m.creepRate);
  r.number("hardening", m.hardening, "Pa", notNegative(),
           "growth of the uniaxial yield stress with the equivalent plastic strain; 0: none");
  r.number("max_plastic_strain", m.maxPlasticStrain, "", orNever(positive()),
           "largest norm of the logarithmic plastic strain (gamma_max), beyond which the material is "
           "elastic; \"never\": no limit");
  r.number("volume_stiffness", m.volumeStiffness, "Pa", notNegative(),
           "k_v of the volume force (Mueller et al. 2004)");
  r.number("hourglass", m.hourglass, "", between(0, 10), "strength of the control of zero-energy modes");
  r.number("break_stretch", m.breakStretch, "", orNever(Range{1, never, true, false, false}),
           "length at which a bond breaks, as a multiple of its rest length; \"never\": no bond breaks");
  r.number("strength", m.strength, "Pa", orNever(positive()),
           "tensile stress at which rigid pieces (law = \"rigid\") break in an impact. It needs `young`, "
           "which sets the duration of the impact. \"never\": they do not break");
  r.number("damping", m.damping, "1/s", notNegative(),
           "rate at which velocity differences of bonded particles decay; vibrations that are many "
           "spacings long decay far more slowly");
  r.flag("weld", m.weld, "solids of this material that touch after freezing weld together");
  r.number(
      "weld_temperature", m.weldTemperature, "K", orNever(positive()),
      "rigid pieces (law = \"rigid\") of this material join where their surfaces touch and both are hotter "
      "than this. Fractures weld only after they have cooled. \"never\": no piece welds");
  r.number("weld_time", m.weldTime, "s", notNegative(),
           "time for which hot surfaces must touch until they weld at `weld_temperature`. 0: pieces stick as "
           "they touch, so they do not rebound");
  r.number("friction", m.friction, "", between(0, 10),
           "Coulomb friction between separate solids: the smaller of the two applies. At an obstacle, that "
           "of the obstacle applies");
  r.number(
      "rolling_friction", m.rollingFriction, "m", notNegative(),
      "largest moment against rolling and spinning at a contact of a rigid piece (law = \"rigid\"), over "
      "the normal force; about 0.01 to 0.1 of the radius of rough stones. Between two pieces the larger "
      "one applies");
  r.number("restitution", m.restitution, "", between(0, 1),
           "restitution of contacts between separate solids and with obstacles: the smaller of the two "
           "applies, so set both for a value above 0.5");
}

void readHeat(TableReader& r, Material& m) {
  r.blend(
      {"conductivity", "W/(m K)", notNegative(), Liquid::Same, "heat conductivity; 0: no heat is conducted"},
      m.conductivity);
  r.blend({"heat_capacity", "J/(kg K)", positive(), Liquid::Same,
           "heat capacity; required for a material that melts"},
          m.heatCapacity);
  r.number("latent_heat", m.latentHeat, "J/kg", notNegative(), "latent heat of melting");
  const std::string melts = !m.melts() ? "none"
                            : m.solidus < m.liquidus
                                ? listText({numberText(m.solidus), numberText(m.liquidus)})
                                : numberText(m.solidus);
  if (const toml::node* n = r.node("melts", "K", meltsRange,
                                   "melting temperature; none: the material does not melt", melts)) {
    const toml::array* a = n->as_array();
    const Range T = positive();
    if (a && a->size() == 2) {
      if (r.quantity(*a->get(0), "melts", "K", T, m.solidus) &&
          r.quantity(*a->get(1), "melts", "K", T, m.liquidus) && m.liquidus < m.solidus)
        r.fail("melts", "the liquidus (second) must not be below the solidus (first)");
    } else if (a) {
      r.refuseValue("melts", "expected one temperature or [solidus, liquidus]");
    } else if (r.quantity(*n, "melts", "K", T, m.solidus)) {
      m.liquidus = m.solidus;
    }
  }
  r.number("hysteresis", m.hysteresis, "", Range{0, 0.5, false, true, false},
           "liquid freezes at or below this liquid fraction, solid melts at or above 1 minus it");
  readTermKeys(r, m, true);
  r.number("paper_diffusivity", m.paperDiffusivity, "m^2/s", notNegative(),
           "k_heat of Keiser et al. 2005, with `numerics.heat = \"paper\"`");
}

void checkExpansion(TableReader& r, const Material& m) {
  if (!m.densityTable.empty() && r.has("expansion"))
    r.fail("expansion", "the table of densities gives the expansion: remove one of the two", {"density"});
  if (r.has("expansion_from") && !expands(m))
    r.fail("expansion_from", "applies only to a liquid with `expansion` or a table of densities",
           {"expansion", "density"});
  if (expands(m) && !canBeLiquid(m))
    r.fail(r.has("expansion") ? "expansion" : "density",
           "only liquids have buoyancy, and this material is always solid: give a single density, or set "
           "`melts`",
           {"young", "phase", "melts"});
}

void checkTension(TableReader& r, const Material& m) {
  if (r.has("contact_angle") && !(m.surfaceTension > 0))
    r.fail("contact_angle", "has no effect without `surface_tension`; set both", {"surface_tension"});
  if (!m.surfaceTensionTable.empty() && !canBeLiquid(m))
    r.fail("surface_tension",
           "only liquids have surface tension, and this material is always solid: remove it, or set `melts`",
           {"young", "phase", "melts"});
}

void checkRigidSolid(TableReader& r, const Material& m) {
  if (m.isRigid()) {
    for (const char* key : {"yield_strain", "creep_rate", "hardening", "max_plastic_strain", "break_stretch"})
      if (r.has(key)) r.fail(key, "has no effect with `law = \"rigid\"`: remove it, or choose another law");
    if (r.has("weld"))
      r.fail("weld",
             "has no effect with `law = \"rigid\"`: rigid pieces weld at `weld_temperature`; remove "
             "`weld`, or choose another law");
  }
  if (r.has("rolling_friction") && !m.isRigid())
    r.fail("rolling_friction", "applies to rigid solids only: set `law = \"rigid\"`, or remove it", {"law"});
  if (m.strength < never && !m.isRigid())
    r.fail("strength", "applies to rigid solids only (`law = \"rigid\"`); others break at `break_stretch`",
           {"law"});
  if (m.strength < never && m.isRigid() && !(m.young.solid > 0))
    r.fail("strength", "needs `young`, which sets the duration of an impact: set it, too", {"young", "law"});
  if (m.weldTemperature < never && !m.isRigid())
    r.fail("weld_temperature",
           "applies to rigid solids only (`law = \"rigid\"`); others weld with `weld = true`", {"law"});
  if (m.weldTemperature < never && m.melts() && m.weldTemperature >= m.liquidus)
    r.fail("weld_temperature",
           "the material melts at " + numberText(m.liquidus) +
               " K, before its pieces weld: expected a lower temperature",
           {"melts"});
  if (m.weldTime > 0 && !(m.weldTemperature < never))
    r.fail("weld_time", "applies only with `weld_temperature`: set it, too", {"weld_temperature"});
}

/// Refuses meaningless combinations of keys.
void checkMaterial(TableReader& r, const Material& m) {
  checkExpansion(r, m);
  checkTension(r, m);
  if (hasPhaseDensities(m) && !m.melts())
    r.fail("density", "only a material that melts has two densities: set `melts`, or give a single density",
           {"melts"});
  if (r.has("melts") && !m.canBeSolid())
    r.fail("melts",
           "a material that melts is a solid below its melting temperature: set `young`, or "
           "`law = \"rigid\"`",
           {"young"});
  if (r.has("melts") && !r.has("heat_capacity"))
    r.fail("heat_capacity", "required, since the material melts");
  if (r.has("phase") && r.has("melts"))
    r.fail("phase", "the temperature decides the phase of a material that melts; leave `phase` out");
  if (r.textOf("phase") == "solid" && !m.canBeSolid())
    r.fail("phase", "a solid needs stiffness: set `young`, or `law = \"rigid\"`", {"young"});
  if (m.latentHeat > 0 && !r.has("melts"))
    r.fail("latent_heat", "only a material that melts has a latent heat: set `melts`, too");
  if (r.has("hysteresis") && !r.has("melts"))
    r.fail("hysteresis", "only a material that melts has hysteresis: set `melts`, too");
  if ((m.yieldStrain.solid < never || m.yieldStrain.liquid < never) && !m.canBeSolid())
    r.fail("yield_strain", "requires a solid: set `young`, or remove `yield_strain`", {"young"});
  if (r.has("creep_rate") && !r.has("yield_strain"))
    r.fail("creep_rate", "only a material that yields creeps: set `yield_strain`, too");
  checkRigidSolid(r, m);
  if (m.hardening > 0 && !r.has("yield_strain"))
    r.fail("hardening", "needs `yield_strain`: only a material that yields can harden");
}

}  // namespace

void readMaterial(TableReader& r, Material& m, SceneReading& x) {
  if (r.reading()) applyQuality(x.scene->quality, m);
  r.restart(Restart::Coefficient);
  readLiquid(r, m);
  readSolid(r, m);
  int phase = m.liquidAtStart ? 1 : 0;
  r.choice(
      "phase", phase, {"solid", "liquid"},
      "phase of a material that does not melt and has a Young's modulus; without a modulus it is liquid");
  m.liquidAtStart = phase == 1;
  readHeat(r, m);
  readHeatExchange(r, m);
  readFlowLaw(r, m);
  if (!r.reading()) return;
  checkMaterial(r, m);
  checkHeatExchange(r, m, x.scene->numerics.heat == HeatModel::Paper);
  if (!m.densityTable.empty())
    m.density = valueAt(m.densityTable, referenceTemperature(x.scene->domain, m), Interpolation::Linear);
  if (m.isRigid()) {
    if (m.strength < never) m.impactModulus = m.young.solid;
    m.young = m.poisson = {};
    m.volumeStiffness = m.hourglass = m.damping = 0;
  }
  if (x.scene->numerics.heat == HeatModel::Paper && hasPhaseDensities(m))
    r.fail("density",
           "`numerics.heat = \"paper\"` has one density for both phases: give a single density, or choose "
           "`heat = \"enthalpy\"`");
  if (x.scene->numerics.heat == HeatModel::Paper && m.melts() && !(m.liquidus > m.solidus))
    r.fail("melts", "with `numerics.heat = \"paper\"` solidus and liquidus must differ");
  x.open.artificialViscosity.push_back(!r.has("artificial_viscosity"));
  x.open.bulkDamping.push_back(!r.has("bulk_damping"));
}

}  // namespace thaw
