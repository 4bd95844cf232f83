// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/flow_laws/flow_law.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "core/fluid/flow_laws/laws.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/scene/temperature_table.hpp"

namespace thaw {
namespace {

/// Reference speed (m/s) for shear rates. It has a small lower bound, for scenes in which nothing moves.
double flowSpeed(const Scene& s) { return std::max(expectedSpeed(s), 1e-3); }

double valueOrZero(const TemperatureTable& t, double T, Interpolation between) {
  return t.empty() ? 0 : valueAt(t, T, between);
}

/// Calls action for the coefficients at each temperature of the tables. Between these temperatures both
/// parameters are monotonic.
template<class Action> void atTableEntries(const FlowLawSettings& s, double leastRate, Action action) {
  std::set<double> temperatures;
  for (const TemperatureTable* t : {&s.yieldStress, &s.consistency})
    for (const auto& point : *t) temperatures.insert(point.first);
  for (const double T : temperatures) action(flowCoefficients(s, leastRate, T));
}

const FlowLawKey* find(const FlowLawRow& row, const std::string& key) {
  for (const FlowLawKey& k : row.keys)
    if (k.name == key) return &k;
  return nullptr;
}

/// Returns the keys of all laws without duplicates.
std::vector<FlowLawKey> allKeys() {
  std::vector<FlowLawKey> all;
  std::set<std::string> names;
  for (const FlowLawRow* row : flowLawTable)
    for (const FlowLawKey& key : row->keys)
      if (names.insert(key.name).second) all.push_back(key);
  return all;
}

void checkKeys(KeyTable& keys, FlowLaw law, const std::vector<FlowLawKey>& all) {
  if (law == FlowLaw::Newtonian) {
    std::string names;
    for (const FlowLawRow* row : flowLawTable)
      names += std::string(row == std::end(flowLawTable)[-1] ? " or "
                           : names.empty()                   ? ""
                                                             : ", ") +
               "\"" + row->name + "\"";
    return keys.fail("law", "required: " + names + "; for a constant viscosity leave out the table `flow`");
  }
  const std::string name = "`law = \"" + std::string(rowOf(law).name) + "\"`";
  for (const FlowLawKey& key : all) {
    const FlowLawKey* own = find(rowOf(law), key.name);
    if (keys.has(key.name) && !own)
      keys.fail(key.name, "not used by " + name + ": remove it, or choose another law");
    if (!keys.has(key.name) && own && own->needed) keys.fail(key.name, "required by " + name);
  }
}

}  // namespace

const FlowLawRow& rowOf(FlowLaw law) { return *flowLawTable[static_cast<std::size_t>(law) - 1]; }

bool hasLeastRate(FlowLaw law) { return law != FlowLaw::Newtonian && find(rowOf(law), leastRateKey.name); }

bool dependsOnTemperature(const FlowLawSettings& s) {
  return s.consistency.size() > 1 || s.yieldStress.size() > 1;
}

void readFlowLaw(KeyTable& keys, FlowLawSettings& s) {
  std::vector<std::string> names{"newtonian"};
  std::string about = "stress at a shear rate g";
  for (const FlowLawRow* row : flowLawTable) {
    names.push_back(row->name);
    about += ". \"" + names.back() + "\": " + row->stress;
  }
  keys.choice("law", s.law, names, about.c_str());
  const std::vector<FlowLawKey> all = allKeys();
  for (const FlowLawKey& key : all) key.declare(keys, key.name, s);
  keys.number("largest_viscosity", s.largestViscosity, "Pa s", notNegative(),
              "limit of the viscosity; 0: none");
  if (keys.reading() && !keys.refused("law")) checkKeys(keys, s.law, all);
}

double leastRateOf(const Scene& s, const Material& m) {
  if (m.flowLaw.leastRate > 0) return m.flowLaw.leastRate;
  constexpr double slow = 1e-4;
  const Vec3d size = s.domain.max - s.domain.min;
  return slow * flowSpeed(s) / std::max({size.x, size.y, size.z});
}

double resolvedRate(const Scene& s) { return flowSpeed(s) / s.spacing; }

FlowCoefficients flowCoefficients(const FlowLawSettings& s, double leastRate, double T) {
  return {&s, valueOrZero(s.yieldStress, T, Interpolation::Linear),
          valueOrZero(s.consistency, T, Interpolation::Logarithmic), leastRate};
}

double apparentViscosity(const FlowCoefficients& c, double rate) {
  const FlowLawSettings& s = *c.settings;
  const double largest = s.largestViscosity > 0 ? s.largestViscosity : never;
  return std::min(rowOf(s.law).viscosity(c, rate), largest);
}

double largestFlowViscosity(const FlowLawSettings& s, double leastRate, double largestRate) {
  double largest = 0;
  atTableEntries(s, leastRate, [&](const FlowCoefficients& c) {
    largest = std::max({largest, apparentViscosity(c, 0), apparentViscosity(c, largestRate)});
  });
  return largest;
}

double leastFlowViscosity(const FlowLawSettings& s, double leastRate, double largestRate) {
  double least = never;
  atTableEntries(s, leastRate, [&](const FlowCoefficients& c) {
    least = std::min({least, apparentViscosity(c, 0), apparentViscosity(c, largestRate)});
  });
  return least;
}

double largestFlowViscosity(const Scene& s, const Material& m) {
  return largestFlowViscosity(m.flowLaw, leastRateOf(s, m), resolvedRate(s));
}

double leastFlowViscosity(const Scene& s, const Material& m) {
  return leastFlowViscosity(m.flowLaw, leastRateOf(s, m), resolvedRate(s));
}

}  // namespace thaw
