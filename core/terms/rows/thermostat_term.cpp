// SPDX-License-Identifier: Apache-2.0
#include "core/heat/heat.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readThermostat(KeyTable& keys, Thermostat& t) {
  keys.restart(Restart::Setting);
  keys.material(t.material, "material that it acts on; none: all");
  keys.needed().number("temperature", t.temperature, "K", positive(), "temperature at the end");
  keys.number("start", t.start, "s", notNegative(), "time at which it starts");
  keys.number("over", t.over, "s", notNegative(), "duration; 0: one step");
  requireKey(keys, "temperature");
}

std::vector<ModuleUse> usesOfThermostats(const Scene& s) {
  if (s.thermostats.empty()) return {};
  return {{&Modules::heat, "a [[thermostat]] changes the temperature"}};
}

OutsideSource startThermostats(const TermSetup&) {
  return [](const OutsideLoad& load) { addThermostats(load.run, load.dt); };
}

}  // namespace

Extension thermostatTerm() {
  return {.name = "thermostats",
          .about = "heat that brings particles to a temperature in a given time",
          .heats = true,
          .model = ModelPart{
              .tables = {termTable<&Scene::thermostats, readThermostat>(
                  "thermostat", "thermostat", "brings particles to a temperature, at any position")},
              .earlyUses = usesOfThermostats,
              .stage = LoadStage::Exchange,
              .start = startThermostats,
              .energies = {"heat_in_J"}}};
}

}  // namespace thaw
