// SPDX-License-Identifier: Apache-2.0
#include "python/src/register_functions.hpp"

#include <pybind11/stl.h>

#include <stdexcept>

#include "core/terms/extensions.hpp"
#include "io/scene/text/units.hpp"
#include "python/src/load_rows.hpp"

namespace py = pybind11;

namespace thaw::python {
namespace {

/// Keeps a function for ever: the registry outlives the interpreter.
const py::function* keep(const py::object& function) { return new py::function(function); }

/// Returns the function that `make` returns for the values, or null if it raises.
Function made(const py::function* make, const ExtensionSettings& settings) {
  Function call;
  guarded([&] { call = keepFunction((*make)(settings.values)); });
  return call;
}

double stepLimit(const std::string& name, const py::function* limit, const ExtensionSettings& settings) {
  double dt = never;
  guarded([&] {
    const py::object value = (*limit)(settings.values);
    double given = 0;
    try {
      given = value.cast<double>();
    } catch (const py::cast_error&) {}  // not a number
    if (!(given > 0))
      throw py::value_error("extension '" + name + "': step_limit returned " +
                            py::repr(value).cast<std::string>() + "; expected seconds above 0");
    dt = given;
  });
  return dt;
}

/// Throws for a unit that scene files do not have. Plain numbers are in it, so it must be in SI.
void checkUnit(const std::string& name, const std::string& key, const std::string& unit) {
  if (unit.empty() || unit == "1") return;
  const Quantity one = parseQuantity("1 " + unit);
  if (one.error.empty() && one.hasUnit && one.value == 1) return;
  throw py::value_error("extension '" + name + "': key '" + key + "' has the unit '" + unit + "'" +
                        (one.error.empty() ? "" : " (" + one.error + ")") +
                        "; expected an SI unit of scene files, such as \"m/s\"");
}

}  // namespace

void registerFunctions(const std::string& name, const std::string& about, const std::vector<KeyNote>& keys,
                       const std::vector<AddedField>& fields, const ExtensionFunctions& functions) {
  Extension e;
  e.name = name;
  e.about = about;
  for (const auto& [key, unit, standard, least, most, meaning] : keys) {
    checkUnit(name, key, unit);
    e.keys.push_back({key, unit, standard, least, most, meaning});
  }
  for (const auto& [field, unit, meaning, components, start] : fields)
    e.fields.push_back({field, unit, meaning, components, start});
  if (!functions.load.is_none())
    e.load = [make = keep(functions.load)](const ExtensionSettings& settings) -> OutsideSource {
      return [call = made(make, settings)](const OutsideLoad& on) {
        if (call) guarded([&] { callLoad(call, on); });
      };
    };
  if (!functions.update.is_none())
    e.update = [make = keep(functions.update)](const ExtensionSettings& settings) -> FieldUpdate {
      return [call = made(make, settings)](const FieldStep& on) {
        if (call) guarded([&] { callWithRows(call, on.particles, on.time, on.dt); });
      };
    };
  if (!functions.stepLimit.is_none())
    e.stepLimit = [name, limit = keep(functions.stepLimit)](const ExtensionSettings& settings) {
      return stepLimit(name, limit, settings);
    };
  e.heats = functions.heats;
  registerExtension(std::move(e));
}

}  // namespace thaw::python
