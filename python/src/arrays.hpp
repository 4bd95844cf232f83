// SPDX-License-Identifier: Apache-2.0
// Numpy arrays over the columns of a table, without copies.
#pragma once
#include <pybind11/numpy.h>

#include <memory>

#include "core/particles/column.hpp"

namespace thaw::python {

/// Number of arrays that Python holds of a simulation's columns. A step moves rows and memory, so none may be
/// alive when one begins.
using ArrayCount = std::shared_ptr<int>;

/// Base object of an array: counts it while it, or an array made from it, is alive.
class ArrayGuard {
 public:
  explicit ArrayGuard(ArrayCount count) : count_(std::move(count)) { ++*count_; }
  ~ArrayGuard() {
    if (count_) --*count_;
  }
  ArrayGuard(ArrayGuard&& other) noexcept = default;
  ArrayGuard(const ArrayGuard&) = delete;
  ArrayGuard& operator=(const ArrayGuard&) = delete;

 private:
  ArrayCount count_;
};

/// Returns an array of the first `rows` rows of a column, with the shape (rows,) or (rows, components).
pybind11::array arrayOf(AnyColumn& column, std::size_t rows, bool writable, const ArrayCount& count);
/// Returns an array over other memory of that form.
pybind11::array arrayOf(double* data, std::size_t rows, int components, const ArrayCount& count);

/// Returns the name in the style of Python: relativeDensity -> relative_density.
std::string pythonName(const char* name);

}  // namespace thaw::python
