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

/// The interface of a simulation's tables (Rows in python/thaw/simulation.py) over the particles of a load.
class LoadRows {
 public:
  LoadRows(Table& table, ArrayCount count) : table_(&table), count_(std::move(count)) {}
  pybind11::array view(const std::string&, const std::string& field, bool) const {
    return arrayOf(columnOf(*table_, field), table_->owned, false, count_);
  }
  std::size_t rows(const std::string&) const { return table_->owned; }
  std::vector<FieldNote> fields(const std::string&) const { return notesOf(*table_); }

 private:
  Table* table_;
  ArrayCount count_;
};

/// Calls a load: call(rows, time, force, heat), where heat is None in a scene without heat. Throws
/// std::runtime_error if the function keeps an array.
void callLoad(const pybind11::function& call, const OutsideLoad& load, const ArrayCount& count);

using KeyNote = std::tuple<std::string, std::string, double, double, double, std::string>;

/// Registers an extension with keys (name, unit, default, least, most, meaning). load(values) returns the
/// function of callLoad; step_limit(values), or None, returns seconds.
void registerFunction(const std::string& name, const std::string& about, const std::vector<KeyNote>& keys,
                      const pybind11::function& load, const pybind11::object& stepLimit);

}  // namespace thaw::python
