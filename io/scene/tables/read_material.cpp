// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include "core/materials/liquid_materials.hpp"
#include "core/scene/buoyancy.hpp"
#include "core/scene/phase_density.hpp"
#include "core/scene/quality.hpp"
#include "core/scene/temperature_table.hpp"
#include "io/scene/tables/read_extension.hpp"
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

constexpr const char* meltsRange = "> 0, one temperature or [solidus, liquidus]";

/// Reads one density at rest, or those of solid and liquid. A table must have both.
void readDensityAtRest(TableReader& r, Material& m) {
  const bool byPhase = r.reading() && r.isTable("density");
  Blend density = byPhase ? Blend{} : Blend{solidDensityOf(m), m.density};
  r.orAs(KeyForm::Type::Pairs)
      .blend({"density", "kg/m^3", positive(), LiquidValue::Same,
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

void readHeat(TableReader& r, Material& m) {
  r.blend({"heat_capacity", "J/(kg K)", positive(), LiquidValue::Same,
           "heat capacity; required for a material that melts"},
          m.heatCapacity);
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
  readTermKeys(r, m, true);
}

/// Refuses meaningless combinations of keys.
void checkMaterial(TableReader& r, const Material& m) {
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
}

}  // namespace

void readMaterial(TableReader& r, Material& m, SceneReading& x) {
  if (r.reading()) applyQuality(x.scene->quality, m);
  r.restart(Restart::Coefficient);
  readDensity(r, m);
  readColourKey(r, m.colour,
                "colour of its surface in pictures and exports, if its mesh has none; default: a pale one");
  readTermKeys(r, m, false);
  readLaw(r, m);
  int phase = m.liquidAtStart ? 1 : 0;
  r.choice(
      "phase", phase, {"solid", "liquid"},
      "phase of a material that does not melt and has a Young's modulus; without a modulus it is liquid");
  m.liquidAtStart = phase == 1;
  readHeat(r, m);
  if (!r.reading()) return;
  checkMaterial(r, m);
  checkTermKeys(r, m, x.scene->numerics);
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
