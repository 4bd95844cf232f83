// SPDX-License-Identifier: Apache-2.0
// RAII wrapper of the HDF5 C API: files of contiguous datasets, texts and numbers. Every return code is
// checked. Failures throw IoError with path, operation and HDF5's reason. HDF5's own error output is off.
#pragma once
#include <mpi.h>

#include <cstdint>
#include <string>
#include <vector>

#include "core/fields/column.hpp"
#include "io/hdf5/io_error.hpp"

namespace thaw {

/// Element types in files. Other: types that thaw does not write.
enum class Element { F64, F32, U64, U32, U16, U8, I64, I32, Other };
Element elementOf(Scalar scalar);
std::size_t bytesOf(Element element);  ///< 0 for Other
const char* nameOf(Element element);   ///< "float64", "uint8", ...

/// Shape of a dataset of rows x components elements; components 0 is one-dimensional, with one component.
/// rowBytes: size of a row.
struct DatasetShape {
  Element element = Element::F64;
  std::uint64_t rows = 0;
  int components = 0;
  std::size_t rowBytes() const {
    return bytesOf(element) * static_cast<std::size_t>(components > 0 ? components : 1);
  }
};

/// Rows [first, first + count) of a dataset.
struct RowRange {
  std::uint64_t first = 0, count = 0;
};

/// MustBe: a file without trailer is an error.
enum class Trailer { MayBe, MustBe };

class H5File {
 public:
  /// Creates a file for this process alone, and replaces an existing one.
  static H5File create(const std::string& path);
  /// Opens an existing file for this process alone, to append.
  static H5File openToAdd(const std::string& path);
  /// Opens an existing file for this process alone, to read. Checks its trailer (file_trailer.hpp), if any,
  /// before HDF5 opens it.
  static H5File openToRead(const std::string& path, Trailer trailer = Trailer::MayBe);
  /// Opens an existing file on all ranks of comm (MPI-IO), to fill its datasets. Collective; so is close.
  static H5File openToFill(const std::string& path, MPI_Comm comm);

  H5File(H5File&& other) noexcept;
  H5File(const H5File&) = delete;
  H5File& operator=(const H5File&) = delete;
  ~H5File();
  /// Writes buffers and closes. Only this reports whether all data were written.
  void close();
  /// Writes buffers to the disk. Collective for files opened by all ranks.
  void flush();
  const std::string& path() const { return path_; }

  // ---- writing. Objects are named by their path in the file: "/VTKHDF/Points"
  void createGroup(const std::string& name);
  /// Creates a contiguous dataset; its space is allocated at once and not filled.
  void createDataset(const std::string& name, const DatasetShape& shape);
  /// Writes a whole small dataset.
  void writeAll(const std::string& name, const DatasetShape& shape, const void* data);
  /// Writes rows of an existing dataset, independently of other ranks. data may be null if range.count is 0.
  void write(const std::string& name, const RowRange& range, const void* data);
  /// Writes a text as a scalar dataset of fixed length (UTF-8).
  void writeText(const std::string& name, const std::string& text);
  /// fixed length, ASCII
  void setText(const std::string& object, const std::string& attribute, const std::string& text);
  void setIntegers(const std::string& object, const std::string& attribute,
                   const std::vector<std::int64_t>& values);
  /// scalar
  void setInteger(const std::string& object, const std::string& attribute, std::int64_t value);
  /// scalar
  void setNumber(const std::string& object, const std::string& attribute, double value);

  // ---- reading ----
  // Missing items and items of another type throw IoError; sizes are checked against the file's before use.
  bool has(const std::string& name) const;
  bool hasAttribute(const std::string& object, const std::string& attribute) const;
  std::vector<std::string> children(const std::string& group) const;     ///< names, ascending
  std::vector<std::string> attributes(const std::string& object) const;  ///< names, ascending
  DatasetShape shape(const std::string& name) const;
  /// Returns the file offset of the rows of a contiguous dataset, which must not be empty.
  std::uint64_t offset(const std::string& name) const;
  /// Reads rows and converts them to `as` if the file's type differs.
  void read(const std::string& name, const RowRange& range, Element as, void* data) const;
  std::string readText(const std::string& name) const;
  std::string text(const std::string& object, const std::string& attribute) const;
  /// returns the first element of an array
  std::int64_t integer(const std::string& object, const std::string& attribute) const;
  std::vector<std::int64_t> integers(const std::string& object, const std::string& attribute) const;
  double number(const std::string& object, const std::string& attribute) const;

 private:
  H5File(std::string path, std::int64_t id, bool alone) : path_(std::move(path)), id_(id), alone_(alone) {}
  [[noreturn]] void fail(const std::string& what) const;
  std::string path_;
  std::int64_t id_ = -1;  // hid_t; -1: closed
  bool alone_ = true;     // not opened together with other ranks
};

/// Returns the rows [0, shape.rows) of a dataset as T, which must have the size of a row of elements `as`.
template<class T> std::vector<T> readRows(const H5File& file, const std::string& name, Element as) {
  std::vector<T> values(file.shape(name).rows);
  if (!values.empty()) file.read(name, {0, values.size()}, as, values.data());
  return values;
}

/// Selects ROMIO for Open MPI's file output: it reports a full disk, where Open MPI's own layer hangs or is
/// silent. A setting of the user (OMPI_MCA_io) is kept. Call before MPI_Init.
void useRomio();

}  // namespace thaw
