// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_heat_exchange.hpp"

#include "core/materials/liquid_materials.hpp"
#include "io/scene/tables/read_flow_law.hpp"

namespace thaw {

void readHeatExchange(TableReader& r, Material& m) {
  r.number("contact_conductance", m.contactConductance, "W/(m^2 K)", orNever(positive()),
           "heat conductance of its contacts with other bodies, if at most one is liquid. The smaller value "
           "of the two materials applies. \"never\": no resistance");
  readByTemperature(r,
                    {"evaporation", "kg/(m^2 s)", notNegative(),
                     "mass that evaporates per time and area of free surfaces of the liquid; or a table of "
                     "pairs by temperature, interpolated linearly; none: no evaporation"},
                    m.evaporation);
  r.number("evaporation_heat", m.evaporationHeat, "J/kg", notNegative(), "latent heat of evaporation");
  r.number("mush_drag", m.mushDrag, "kg/(m^3 s)", notNegative(),
           "coefficient C of the drag C (1 - f)^2 / (f^3 + 0.001) of solid neighbours on the liquid. It acts "
           "while the liquid fraction f is below 1. 0: none");
}

void checkHeatExchange(TableReader& r, const Material& m, bool paper) {
  for (const char* key : {"contact_conductance", "evaporation"})
    if (paper && r.has(key)) r.fail(key, "not available with `numerics.heat = \"paper\"`; use \"enthalpy\"");
  if (r.has("contact_conductance") && !(m.conductivity.solid > 0 || m.conductivity.liquid > 0))
    r.fail("contact_conductance", "has no effect without `conductivity`; set both");
  if (r.has("evaporation") && !canBeLiquid(m))
    r.fail("evaporation",
           "only liquids evaporate, and this material is always solid: remove it, or set `melts`",
           {"young", "phase"});
  if (r.has("evaporation_heat") && !r.has("evaporation"))
    r.fail("evaporation_heat", "has no effect without `evaporation`; set both");
  if (r.has("mush_drag") && !r.has("melts")) r.fail("mush_drag", "has no effect without `melts`; set both");
}

}  // namespace thaw
