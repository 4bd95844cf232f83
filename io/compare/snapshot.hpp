// SPDX-License-Identifier: Apache-2.0
// Frame or checkpoint for comparison: numbers, and tables of columns whose rows have ids. Columns are read
// one at a time.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "io/hdf5/h5_file.hpp"

namespace thaw {

/// Number of the whole state: time, counters, ledger.
struct SnapshotNumber {
  std::string name, unit;
  bool whole = false;  ///< an integer: use `integer`
  double value = 0;
  std::int64_t integer = 0;
  std::vector<std::int64_t> digits;  ///< digits of an exact sum; else empty
};

struct SnapshotColumn {
  std::string name, path, unit;
  DatasetShape shape;
};

/// Rows with ids. order: rows ascending by id.
struct SnapshotTable {
  std::string title;  ///< "particles", "solids", "surfels", "components", "events", "oriented", "sheet"
  std::vector<std::uint64_t> ids, order;
  std::vector<SnapshotColumn> columns;
  std::vector<std::uint64_t> firstBond;  ///< per row, plus the end; empty without bonds
  std::vector<SnapshotColumn> bonds;     ///< one row per bond
};

struct Snapshot {
  H5File file;
  std::string kind;  ///< "frame" or "checkpoint"
  std::vector<SnapshotNumber> numbers;
  std::map<std::string, std::string> values;  ///< texts of the restart record of a checkpoint
  std::vector<SnapshotTable> tables;
};

/// Opens a frame, a checkpoint, or the last checkpoint of a run's folder. Fields that depend on the number of
/// ranks ("rank" and internal ones) are omitted. Throws IoError if there is none, or it is damaged.
Snapshot openSnapshot(const std::string& path);

/// Returns `path`, or the last checkpoint of a run's folder. Throws IoError if the folder has none that can
/// be read.
std::string snapshotPath(const std::string& path);

}  // namespace thaw
