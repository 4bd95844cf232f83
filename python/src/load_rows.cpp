// SPDX-License-Identifier: Apache-2.0
#include "python/src/load_rows.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <stdexcept>

namespace py = pybind11;

namespace thaw::python {

namespace {

/// Fields with a meaning only inside of a step or of the library.
constexpr const char* internalFields[] = {"frame", "justFrozen", "setLabel", "newborn", "tension_force"};

/// Returns true for a field that Python programs can read. Indices of a rank's rows and packed data, wider
/// than a matrix, are not offered.
bool isOffered(const AnyColumn& c) {
  return c.active && c.keep != Keep::Local && c.components <= 9 &&
         std::none_of(std::begin(internalFields), std::end(internalFields),
                      [&](const char* name) { return std::strcmp(name, c.name) == 0; });
}

}  // namespace

std::vector<FieldNote> notesOf(const Table& table) {
  std::vector<FieldNote> all;
  for (const AnyColumn* c : table.columns)
    if (isOffered(*c)) all.emplace_back(pythonName(c->name), c->unit, c->about, c->components);
  return all;
}

AnyColumn& columnOf(Table& table, const std::string& field) {
  for (AnyColumn* c : table.columns)
    if (isOffered(*c) && pythonName(c->name) == field) return *c;
  throw py::key_error(field);
}

bool isAdded(const Table& table, const AnyColumn& column) {
  return std::strcmp(table.kind, "continuum") == 0 &&
         static_cast<const Continuum&>(table).addedField(column.name) == &column;
}

Table& LoadRows::table() const {
  if (!open_->table) throw std::runtime_error("the rows are valid during the call of the function only");
  return *open_->table;
}

py::array LoadRows::view(const std::string&, const std::string& field, bool) const {
  AnyColumn& column = columnOf(table(), field);
  return open_->arrays->of(column, table().owned, isAdded(table(), column));
}

RowsOfCall::RowsOfCall(Table& table, ProgramCalls& calls)
    : calls_(calls), open_(std::make_shared<OpenRows>(OpenRows{&table, &calls.arrays})) {
  calls_.depth++;
}

RowsOfCall::~RowsOfCall() {
  calls_.depth--;
  *open_ = {};
  calls_.arrays.release();
}

void callLoad(const Function& call, const OutsideLoad& load) {
  ProgramCalls& calls = currentCalls();
  const std::size_t n = load.particles.owned;
  const RowsOfCall of(load.particles, calls);
  // A source adds to the column of forces itself. Heat has no column, so its array is added afterwards.
  const py::array force = calls.arrays.of(load.particles.outsideForce, n, true);
  py::object heat = py::none();
  if (load.heat) {
    py::array_t<double> flow(static_cast<py::ssize_t>(n));
    std::fill_n(flow.mutable_data(), n, 0.0);
    heat = flow;
  }
  (*call)(of.rows(), load.time, force, heat);
  if (!load.heat) return;
  const double* flow = heat.cast<py::array_t<double>>().data();
  for (std::size_t i = 0; i < n; i++) load.heat[i] += flow[i];
}

}  // namespace thaw::python
