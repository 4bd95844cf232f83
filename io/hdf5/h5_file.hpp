// A thin RAII wrapper over the HDF5 C API: files of contiguous datasets, text and numbers. Every return code
// is checked; failures are thrown as IoError with the path, what was tried and what HDF5 says about it.
// HDF5's own printing of errors is off.
#pragma once
#include <mpi.h>

#include <cstdint>
#include <string>
#include <vector>

#include "core/particles/column.hpp"
#include "io/hdf5/io_error.hpp"

namespace thaw {

/// Types of elements in files. Other: something that thaw does not write.
enum class Element { F64, F32, U64, U32, U16, U8, I64, I32, Other };
Element elementOf(Scalar scalar);
std::size_t bytesOf(Element element);  ///< 0 for Other
const char* nameOf(Element element);   ///< "float64", "uint8", ...

/// rows x components elements; components 0: one-dimensional (as 1 component, but of rank 1). Row: bytes of
/// one row.
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

/// MustBe: a file without trailer is refused.
enum class Trailer { MayBe, MustBe };

class H5File {
 public:
  /// A new file, for this process alone; one that is there is replaced.
  static H5File create(const std::string& path);
  /// An existing file, for this process alone, to add to.
  static H5File openToAdd(const std::string& path);
  /// An existing file, for this process alone, to read. One with a trailer (file_trailer.hpp) is compared
  /// with it before HDF5 opens it.
  static H5File openToRead(const std::string& path, Trailer trailer = Trailer::MayBe);
  /// An existing file, to fill its datasets from all ranks of comm (MPI-IO). Collective; so is close.
  static H5File openToFill(const std::string& path, MPI_Comm comm);

  H5File(H5File&& other) noexcept;
  H5File(const H5File&) = delete;
  H5File& operator=(const H5File&) = delete;
  ~H5File();
  /// Writes out what is buffered, and closes. Only this tells whether all of it could be written.
  void close();
  /// Writes out what is buffered, to the disk itself. Collective where the file is.
  void flush();
  const std::string& path() const { return path_; }

  // ---- writing. Objects are named by their path in the file: "/VTKHDF/Points"
  void createGroup(const std::string& name);
  /// Contiguous, its place in the file taken at once, not filled.
  void createDataset(const std::string& name, const DatasetShape& shape);
  /// A whole small dataset.
  void writeAll(const std::string& name, const DatasetShape& shape, const void* data);
  /// Rows of a dataset that is there; independent of other ranks. data may be null if range.count is 0.
  void write(const std::string& name, const RowRange& range, const void* data);
  /// A text of any length as a scalar dataset of fixed length (UTF-8).
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
  // Missing items and items of another type are an IoError; sizes are checked against the file's before use.
  bool has(const std::string& name) const;
  bool hasAttribute(const std::string& object, const std::string& attribute) const;
  std::vector<std::string> children(const std::string& group) const;     ///< names, ascending
  std::vector<std::string> attributes(const std::string& object) const;  ///< names, ascending
  DatasetShape shape(const std::string& name) const;
  /// Byte of the file at which the rows of a contiguous dataset begin; it has some.
  std::uint64_t offset(const std::string& name) const;
  /// Converts to `as` where the file's type is another one.
  void read(const std::string& name, const RowRange& range, Element as, void* data) const;
  std::string readText(const std::string& name) const;
  std::string text(const std::string& object, const std::string& attribute) const;
  /// the first, of an array
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

/// Rows [0, shape.rows) of a dataset as T, which must have the size of a row of elements `as`.
template<class T> std::vector<T> readRows(const H5File& file, const std::string& name, Element as) {
  std::vector<T> values(file.shape(name).rows);
  if (!values.empty()) file.read(name, {0, values.size()}, as, values.data());
  return values;
}

/// To be called before MPI_Init: has Open MPI write files by ROMIO, which reports a full disk where its own
/// layer hangs or says nothing. A choice of the user's own (OMPI_MCA_io) stays.
void useRomio();

}  // namespace thaw
