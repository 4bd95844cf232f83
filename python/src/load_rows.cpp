// SPDX-License-Identifier: Apache-2.0
#include "python/src/load_rows.hpp"

#include <pybind11/stl.h>

#include <cstring>
#include <stdexcept>

namespace py = pybind11;

namespace thaw::python {

std::vector<FieldNote> notesOf(const Table& table) {
  std::vector<FieldNote> all;
  for (const AnyColumn* c : table.columns)
    if (c->active) all.emplace_back(pythonName(c->name), c->unit, c->about, c->components);
  return all;
}

AnyColumn& columnOf(Table& table, const std::string& field) {
  for (AnyColumn* c : table.columns)
    if (c->active && pythonName(c->name) == field) return *c;
  throw py::key_error(field);
}

bool isAdded(const Table& table, const AnyColumn& column) {
  return std::strcmp(table.kind, "continuum") == 0 &&
         static_cast<const Continuum&>(table).addedField(column.name) == &column;
}

void callLoad(const py::function& call, const OutsideLoad& load, const ArrayCount& count) {
  const std::size_t n = load.particles.owned;
  const int before = *count;
  {
    const py::object heat = load.heat ? py::object(arrayOf(load.heat, n, 1, count)) : py::none();
    call(LoadRows(load.particles, count), load.time, arrayOf(&load.force->x, n, 3, count), heat);
  }
  if (*count > before)
    throw std::runtime_error("a force or heat source keeps an array of the simulation; copy its values");
}

namespace {

/// Keeps a function for ever: the registry outlives the interpreter.
const py::function* keep(const py::object& function) { return new py::function(function); }

}  // namespace

void registerFunctions(const std::string& name, const std::string& about, const std::vector<KeyNote>& keys,
                       const std::vector<AddedField>& fields, const ExtensionFunctions& functions) {
  Extension e;
  e.name = name;
  e.about = about;
  for (const auto& [key, unit, standard, least, most, meaning] : keys)
    e.keys.push_back({key, unit, standard, least, most, meaning});
  for (const auto& [field, unit, meaning, components, start] : fields)
    e.fields.push_back({field, unit, meaning, components, start});
  if (!functions.load.is_none())
    e.load = [make = keep(functions.load)](const ExtensionSettings& settings) -> OutsideSource {
      const py::gil_scoped_acquire python;
      return [call = py::function((*make)(settings.values)),
              count = std::make_shared<int>(0)](const OutsideLoad& on) {
        const py::gil_scoped_acquire held;
        callLoad(call, on, count);
      };
    };
  if (!functions.update.is_none())
    e.update = [make = keep(functions.update)](const ExtensionSettings& settings) -> FieldUpdate {
      const py::gil_scoped_acquire python;
      return [call = py::function((*make)(settings.values)),
              count = std::make_shared<int>(0)](const FieldStep& on) {
        const py::gil_scoped_acquire held;
        callWithRows(call, on.particles, count, on.time, on.dt);
      };
    };
  if (!functions.stepLimit.is_none())
    e.stepLimit = [limit = keep(functions.stepLimit)](const ExtensionSettings& settings) {
      const py::gil_scoped_acquire python;
      return (*limit)(settings.values).cast<double>();
    };
  e.heats = functions.heats;
  registerExtension(std::move(e));
}

}  // namespace thaw::python
