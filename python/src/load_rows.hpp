// SPDX-License-Identifier: Apache-2.0
// The particles that a function of a Python program reads during its call within a step.
#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <tuple>
#include <vector>

#include "core/terms/outside_forces.hpp"
#include "python/src/program_calls.hpp"

namespace thaw::python {

/// Name, unit, meaning, components.
using FieldNote = std::tuple<std::string, std::string, std::string, int>;
/// Returns the fields that Python programs can read.
std::vector<FieldNote> notesOf(const Table& table);
/// Returns the column of such a field by its name in Python. Throws KeyError.
AnyColumn& columnOf(Table& table, const std::string& field);

/// Returns true for a field of an extension, which programs may write.
bool isAdded(const Table& table, const AnyColumn& column);

/// Access to a table during a call. The end of the call closes it.
struct OpenRows {
  Table* table = nullptr;  ///< null: closed
  ColumnArrays* arrays = nullptr;
};

/// The interface of a simulation's tables (Rows in python/thaw/rows.py) over the particles of a call. Throws
/// std::runtime_error after the call.
class LoadRows {
 public:
  explicit LoadRows(std::shared_ptr<OpenRows> open) : open_(std::move(open)) {}
  pybind11::array view(const std::string& table, const std::string& field, bool writable) const;
  std::size_t rows(const std::string&) const { return table().owned; }
  std::vector<FieldNote> fields(const std::string&) const { return notesOf(table()); }

 private:
  Table& table() const;
  std::shared_ptr<OpenRows> open_;
};

/// Rows of a table for one call. Arrays that the function keeps are separated from the simulation at the end.
class RowsOfCall {
 public:
  RowsOfCall(Table& table, ProgramCalls& calls);
  ~RowsOfCall();
  RowsOfCall(const RowsOfCall&) = delete;
  RowsOfCall& operator=(const RowsOfCall&) = delete;
  LoadRows rows() const { return LoadRows(open_); }

 private:
  ProgramCalls& calls_;
  std::shared_ptr<OpenRows> open_;
};

/// Calls call(rows, numbers...).
template<class... Numbers> void callWithRows(const Function& call, Table& table, Numbers... numbers) {
  const RowsOfCall of(table, currentCalls());
  (*call)(of.rows(), numbers...);
}

/// Calls a load: call(rows, time, force, heat), where heat is None in a scene without heat.
void callLoad(const Function& call, const OutsideLoad& load);

}  // namespace thaw::python
