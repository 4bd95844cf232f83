// SPDX-License-Identifier: Apache-2.0
// One field of a table of particles: a contiguous array with its name, unit and meaning.
// Sorting, migration, ghost exchange, checkpoints and output work on AnyColumn, so a field is declared once,
// in its table.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/fields/aligned_memory.hpp"
#include "core/math/mat3.hpp"
#include "core/math/quat.hpp"

namespace thaw {

enum class Scalar { F64, F32, U64, U32, U16, U8 };
inline std::size_t bytesOf(Scalar s) {
  return s == Scalar::F64 || s == Scalar::U64   ? 8
         : s == Scalar::F32 || s == Scalar::U32 ? 4
         : s == Scalar::U16                     ? 2
                                                : 1;
}

/// Lifetime of a field.
enum class Keep {
  State,     ///< part of the state: sorted, migrated, in every checkpoint, compared bit by bit
  Local,     ///< sorted with the particles, but valid on this rank only (indices); not migrated, not in a
             ///< checkpoint
  Transient  ///< recomputed in each step before it is read; only resized
};

/// Rows for which a field has values.
enum class Rows {
  All,
  Owned  ///< no ghost rows, so the field takes part in no ghost exchange
};

/// Returns the capacity to reserve for `rows` rows. Rows enter and leave through faces: the head room is a
/// sixteenth for small tables and about a layer of particles for large ones.
std::size_t withHeadRoom(std::size_t rows);
/// Reserves memory for `rows` rows of `each` elements. The first allocation is exact, which saves memory in
/// serial runs. Later growth adds head room, so that steady steps allocate nothing.
template<class T> void makeRoom(AlignedVector<T>& v, std::size_t rows, std::size_t each = 1) {
  if (rows * each > v.capacity()) v.reserve((v.capacity() == 0 ? rows : withHeadRoom(rows)) * each);
}

template<class T> struct FieldType;  // scalar type and number of components of T
template<> struct FieldType<double> {
  static constexpr Scalar scalar = Scalar::F64;
  static constexpr int components = 1;
};
template<> struct FieldType<float> {
  static constexpr Scalar scalar = Scalar::F32;
  static constexpr int components = 1;
};
template<> struct FieldType<std::uint64_t> {
  static constexpr Scalar scalar = Scalar::U64;
  static constexpr int components = 1;
};
template<> struct FieldType<std::uint32_t> {
  static constexpr Scalar scalar = Scalar::U32;
  static constexpr int components = 1;
};
template<> struct FieldType<std::uint16_t> {
  static constexpr Scalar scalar = Scalar::U16;
  static constexpr int components = 1;
};
template<> struct FieldType<std::uint8_t> {
  static constexpr Scalar scalar = Scalar::U8;
  static constexpr int components = 1;
};
template<class S> struct FieldType<Vec3<S>> {
  static constexpr Scalar scalar = FieldType<S>::scalar;
  static constexpr int components = 3;
};
template<class S> struct FieldType<Sym3<S>> {
  static constexpr Scalar scalar = FieldType<S>::scalar;
  static constexpr int components = 6;
};
template<class S> struct FieldType<Mat3<S>> {
  static constexpr Scalar scalar = FieldType<S>::scalar;
  static constexpr int components = 9;
};
template<> struct FieldType<Quat> {
  static constexpr Scalar scalar = Scalar::F64;
  static constexpr int components = 4;
};

struct Table;

/// New positions of the rows of a table. Most rows keep their order, so the moves are stored as runs of
/// consecutive rows and as single rows. All other rows are dropped.
struct RowMoves {
  struct Run {
    std::uint32_t from, to, count;
  };
  struct Single {
    std::uint32_t from, to;
  };
  std::vector<Run> runs;        ///< `from` and `to` ascending
  std::vector<Single> singles;  ///< in any order
  std::size_t rows = 0;         ///< number of rows afterwards; every smaller index is the target of exactly
                                ///< one row
};

/// A field without its C++ type. Inactive columns hold no memory.
struct AnyColumn {
  const char* name;
  const char* unit;
  const char* about;
  Keep keep;
  Scalar scalar;
  int components;
  std::size_t elementBytes;
  Rows rows;
  bool active = false;
  AlignedVector<std::byte> bytes;  ///< rows * elementBytes

  AnyColumn(Table& table, const char* name, const char* unit, Keep keep, const char* about, Scalar scalar,
            int components, Rows rows);
  AnyColumn(const AnyColumn&) = delete;
  AnyColumn& operator=(const AnyColumn&) = delete;
};

template<class T> struct Column : AnyColumn {
  static_assert(std::is_trivially_copyable_v<T>);
  Column(Table& table, const char* name, const char* unit, Keep keep, const char* about,
         Rows rows = Rows::All)
      : AnyColumn(table, name, unit, keep, about, FieldType<T>::scalar, FieldType<T>::components, rows) {}
  T* data() { return reinterpret_cast<T*>(bytes.data()); }
  const T* data() const { return reinterpret_cast<const T*>(bytes.data()); }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
};

/// A field that may share the memory of a host column whose rows have the same width. A sharing field is not
/// active, has no memory of its own and takes part in no exchange. Writes to the host overwrite its values.
template<class T> struct GuestColumn : Column<T> {
  using Column<T>::Column;
  void shareWith(AnyColumn& other) {
    if (other.elementBytes != sizeof(T) || other.rows != this->rows)
      throw std::logic_error("a guest column needs a host with the same row width and row set");
    host_ = &other;
  }
  bool shares() const { return host_ != nullptr; }
  T* data() { return host_ ? reinterpret_cast<T*>(host_->bytes.data()) : Column<T>::data(); }
  const T* data() const {
    return host_ ? reinterpret_cast<const T*>(host_->bytes.data()) : Column<T>::data();
  }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }

 private:
  AnyColumn* host_ = nullptr;
};

/// Base of every table of fields. Rows [0, owned) belong to this rank; rows [owned, owned + ghosts) are
/// copies of other ranks' rows or periodic images. Columns register themselves in the order of their
/// declaration.
struct Table {
  const char* kind = "";  ///< "continuum", "solid", ...
  std::vector<AnyColumn*> columns;
  std::size_t owned = 0, ghosts = 0;

  explicit Table(const char* kind) : kind(kind) {}
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  std::size_t size() const { return owned + ghosts; }
  std::size_t rowsOf(const AnyColumn& column) const { return column.rows == Rows::Owned ? owned : size(); }
  /// Sets the number of rows. Remaining rows keep their values, new rows are zero. The capacity never
  /// shrinks.
  void resize(std::size_t owned, std::size_t ghosts);
  /// Frees capacity that exceeds the rows by more than the fraction `part`, as after a change of the
  /// partition.
  void shrink(double part = 0.125);
  /// Activates a field: allocates zeroed rows.
  void activate(AnyColumn& column);
  /// Deactivates a field and frees its memory.
  void deactivate(AnyColumn& column);
  /// Reserves memory for exactly `rows` rows, so that later rows need no allocation.
  void reserve(std::size_t rows);
  /// Row i of every Keep::State and Keep::Local column becomes old row order[i], for i < n = number of kept
  /// rows. Sets owned = n, ghosts = 0. Stale columns are only resized: they are written before they are read.
  void reorder(std::span<const std::uint32_t> order, std::span<AnyColumn* const> stale = {});
  /// Reorders rows in place. Rows that keep their index are not copied, and no second column is needed. Stale
  /// columns are only resized.
  void rearrange(const RowMoves& moves, std::span<AnyColumn* const> stale);
  /// Returns the size of the reorder buffers in bytes.
  std::size_t bufferBytes() const;
  AnyColumn* find(const char* name);
  /// Returns the bytes of one row in the active State columns. packState and unpackState serve migration,
  /// ghost exchange and checkpoints.
  std::size_t stateBytes() const;
  void packState(std::size_t row, std::byte* to) const;
  void unpackState(std::size_t row, const std::byte* from);

 private:
  // Buffers into which reorder writes, by elementBytes. They are swapped with the columns.
  std::vector<std::pair<std::size_t, AlignedVector<std::byte>>> spares_;
  std::vector<std::byte> singles_;  // single rows of the column that is being moved
};

/// A list of columns for an exchange. It has fixed storage, since a step builds several lists.
class ColumnList {
 public:
  ColumnList(std::initializer_list<AnyColumn*> columns) {
    for (AnyColumn* c : columns) push_back(c);
  }
  void push_back(AnyColumn* column) {
    if (count_ == column_.size()) throw std::logic_error("ColumnList is full");
    column_[count_++] = column;
  }
  bool empty() const { return count_ == 0; }
  operator std::span<AnyColumn* const>() const { return {column_.data(), count_}; }

 private:
  std::array<AnyColumn*, 40> column_{};
  std::size_t count_ = 0;
};

}  // namespace thaw
