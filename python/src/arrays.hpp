// SPDX-License-Identifier: Apache-2.0
// Numpy arrays over the columns of a table, without copies.
#pragma once
#include <pybind11/numpy.h>

#include <map>
#include <memory>
#include <string>

#include "core/fields/column.hpp"

namespace thaw::python {

/// Memory that outlives its column: empty while the column has it.
struct KeptMemory {
  AlignedVector<std::byte> bytes;
};

/// Base object of an array: keeps the memory of its values.
struct ArrayGuard {
  std::shared_ptr<KeptMemory> memory;
};

/// The arrays that Python holds of the columns of a simulation. They share the columns' memory until
/// release(), which separates those that are still in use. These keep the memory with their last values, and
/// the column gets a copy. No array thus reads freed memory, and none that is kept changes the simulation.
class ColumnArrays {
 public:
  ColumnArrays() = default;
  ColumnArrays(const ColumnArrays&) = delete;
  ColumnArrays& operator=(const ColumnArrays&) = delete;
  /// Returns an array of the first `rows` rows of a column, with the shape (rows,) or (rows, components).
  pybind11::array of(AnyColumn& column, std::size_t rows, bool writable);
  /// Separates all arrays. Requires: no other pointers to the columns' memory are in use.
  void release();
  /// Gives the memory of all arrays away, before the columns end.
  void releaseFromEnd();
  /// Number of columns of which Python holds arrays.
  int count() const;

 private:
  std::map<AnyColumn*, std::weak_ptr<KeptMemory>> kept_;
};

/// Type of the values of a column.
pybind11::dtype typeOf(Scalar scalar);

/// Returns the name in the style of Python: relativeDensity -> relative_density.
std::string pythonName(const char* name);

}  // namespace thaw::python
