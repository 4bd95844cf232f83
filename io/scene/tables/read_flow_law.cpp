// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_flow_law.hpp"

#include "core/materials/liquid_materials.hpp"

namespace thaw {
namespace {

void readKeys(TableReader& r, FlowLawSettings& f) {
  r.choice("law", f.law, {"newtonian", "bingham", "herschel_bulkley", "power_law", "carreau"},
           "stress at a shear rate g. \"bingham\": yield_stress + viscosity g. \"herschel_bulkley\": "
           "yield_stress + viscosity g^n with n = exponent and g in 1/s. \"power_law\": the same without "
           "yield stress. \"carreau\": the viscosity falls from `viscosity` to `infinite_viscosity`");
  readByTemperature(r,
                    {"yield_stress", "Pa", notNegative(),
                     "shear stress below which the liquid does not flow; or a table of pairs by temperature, "
                     "interpolated linearly"},
                    f.yieldStress);
  readByTemperature(r,
                    {"viscosity", "Pa s", positive(),
                     "bingham: plastic viscosity. herschel_bulkley and power_law: consistency, which is the "
                     "viscosity at a shear rate of 1/s without the yield stress. carreau: viscosity at rest. "
                     "Or a table of pairs by temperature, interpolated logarithmically"},
                    f.consistency);
  r.number("exponent", f.exponent, "", between(0.1, 3),
           "n of herschel_bulkley, power_law and carreau; below 1 the liquid is shear-thinning");
  r.number("infinite_viscosity", f.infiniteViscosity, "Pa s", notNegative(),
           "viscosity of carreau at high shear rates");
  r.number("relaxation_time", f.relaxationTime, "s", notNegative(),
           "carreau: inverse of the shear rate at which thinning begins");
  r.number("least_rate", f.leastRate, "1/s", notNegative(),
           "shear rate below which the law is regularised: a liquid below its yield stress creeps at most at "
           "this rate. 0: 1e-4 of the expected speed (at least 1 mm/s) over the longest side of the domain");
  r.number("largest_viscosity", f.largestViscosity, "Pa s", notNegative(), "limit of the viscosity; 0: none");
}

/// Refuses keys that the law does not have. Requires those that it needs.
void checkKeys(TableReader& r, FlowLaw law) {
  if (r.refused("law")) return;
  if (law == FlowLaw::Newtonian)
    return r.fail("law",
                  "required: \"bingham\", \"herschel_bulkley\", \"power_law\" or \"carreau\"; for a "
                  "constant viscosity leave out the table `flow`");
  const bool yields = law == FlowLaw::Bingham || law == FlowLaw::HerschelBulkley;
  const bool carreau = law == FlowLaw::Carreau;
  const struct {
    const char* key;
    bool has, needs;
  } keys[] = {{"yield_stress", yields, yields},
              {"viscosity", true, true},
              {"exponent", law != FlowLaw::Bingham, law != FlowLaw::Bingham},
              {"infinite_viscosity", carreau, false},
              {"relaxation_time", carreau, carreau},
              {"least_rate", !carreau, false}};
  for (const auto& k : keys) {
    if (r.has(k.key) && !k.has)
      r.fail(k.key, "not used by `law = \"" + r.textOf("law") + "\"`: remove it, or choose another law");
    if (!r.has(k.key) && k.needs) r.fail(k.key, "required by `law = \"" + r.textOf("law") + "\"`");
  }
}

}  // namespace

void readByTemperature(TableReader& r, const TemperatureKey& k, TemperatureTable& t) {
  if (r.hasList(k.key) || t.size() > 1)
    return r.pairs({k.key, "K", k.unit, {0, never, true, false, false}, k.range, "", k.about}, t);
  std::optional<double> value;
  if (!t.empty()) value = t.front().second;
  r.orAs(KeyForm::Type::Pairs).number(k.key, value, k.unit, k.range, k.about);
  if (value) t = {{0, *value}};
}

void readFlowLaw(TableReader& material, Material& m) {
  material.table("flow",
                 "viscosity that depends on the shear rate, instead of `viscosity`: liquids with a yield "
                 "stress, shear-thinning and shear-thickening liquids (docs/theory/rheology.md)",
                 m.flowLaw.law != FlowLaw::Newtonian, [&](TableReader& r) {
                   readKeys(r, m.flowLaw);
                   if (r.reading()) checkKeys(r, m.flowLaw.law);
                 });
  if (!material.reading() || !material.has("flow")) return;
  if (material.has("viscosity"))
    material.fail("viscosity", "the table `flow` sets the viscosity: remove one of the two");
  if (!canBeLiquid(m))
    material.fail("flow",
                  "this material is never liquid: remove `flow`, or set `melts` or `phase = \"liquid\"`");
}

}  // namespace thaw
