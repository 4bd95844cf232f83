// SPDX-License-Identifier: Apache-2.0
// The particles that a force or heat source of a Python program reads, during its call.
#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <tuple>
#include <vector>

#include "core/domain/extensions.hpp"
#include "python/src/arrays.hpp"

namespace thaw::python {

/// Name, unit, meaning, components.
using FieldNote = std::tuple<std::string, std::string, std::string, int>;
std::vector<FieldNote> notesOf(const Table& table);
/// Returns the active column of that name in Python. Throws KeyError.
AnyColumn& columnOf(Table& table, const std::string& field);

/// Returns true for a field of an extension, which programs may write.
bool isAdded(const Table& table, const AnyColumn& column);

/// The interface of a simulation's tables (Rows in python/thaw/simulation.py) over the particles of a load.
class LoadRows {
 public:
  LoadRows(Table& table, ArrayCount count) : table_(&table), count_(std::move(count)) {}
  pybind11::array view(const std::string&, const std::string& field, bool) const {
    AnyColumn& column = columnOf(*table_, field);
    return arrayOf(column, table_->owned, isAdded(*table_, column), count_);
  }
  std::size_t rows(const std::string&) const { return table_->owned; }
  std::vector<FieldNote> fields(const std::string&) const { return notesOf(*table_); }

 private:
  Table* table_;
  ArrayCount count_;
};

/// Calls call(rows, numbers...). Throws std::runtime_error if the function keeps an array.
template<class... Numbers>
void callWithRows(const pybind11::function& call, Table& table, const ArrayCount& count, Numbers... numbers) {
  const int before = *count;
  call(LoadRows(table, count), numbers...);
  if (*count > before)
    throw std::runtime_error("a function keeps an array of the simulation; copy its values");
}

/// Calls a load: call(rows, time, force, heat), where heat is None in a scene without heat. Throws
/// std::runtime_error if the function keeps an array.
void callLoad(const pybind11::function& call, const OutsideLoad& load, const ArrayCount& count);

using KeyNote = std::tuple<std::string, std::string, double, double, double, std::string>;

/// (name, unit, meaning, components, start value)
using AddedField = std::tuple<std::string, std::string, std::string, int, double>;

/// Functions of an extension, each None or made for the values of a scene. load(values) returns the function
/// of callLoad; update(values) a function of (rows, time, dt); step_limit(values) seconds.
struct ExtensionFunctions {
  pybind11::object load, update, stepLimit;
  bool heats = false;
};

/// Registers an extension with keys (name, unit, default, least, most, meaning).
void registerFunctions(const std::string& name, const std::string& about, const std::vector<KeyNote>& keys,
                       const std::vector<AddedField>& fields, const ExtensionFunctions& functions);

}  // namespace thaw::python
