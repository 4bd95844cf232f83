// Writes one HDF5 file from all ranks so that it is either whole or not there: rank 0 lays the file out as
// "name.part" and reserves its room, all ranks fill in their rows (independent MPI-IO writes of contiguous
// datasets), the file is opened again and checked, and rank 0 appends a trailer with a checksum
// (file_trailer.hpp) and renames it. Since the layout is complete before others open the file, no metadata is
// written in parallel, and a full disk is one rank's failed write, which all then agree on.
#pragma once
#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

#include "io/hdf5/agree.hpp"
#include "io/hdf5/h5_file.hpp"

namespace thaw {

/// Rows of a dataset that is spread over the ranks.
struct SpreadDataset {
  std::string name;            ///< path in the file
  DatasetShape shape;          ///< shape.rows: of all ranks
  RowRange mine;               ///< rows of this rank
  const void* data = nullptr;  ///< mine.count rows, or nullptr: `fill` gives them
  std::string unit;            ///< attribute "units"; empty: none
  /// Writes rows [first, first + count) of this rank (0: its first) to `to`; called for a piece at a time,
  /// several times for each.
  std::function<void(const RowRange& local, std::byte* to)> fill;
};

struct ParallelFileContent {
  std::vector<std::string> groups;      ///< parents before children
  std::vector<SpreadDataset> datasets;  ///< the same names and shapes on all ranks
  std::function<void(H5File&)> small;   ///< rank 0 only: texts, attributes, small datasets
  std::uint64_t smallBytes = 0;         ///< of long texts in it
  bool checked = false;  ///< keep a checksum of each dataset in the file (attribute "checksum"), read all
                         ///< rows back and compare, sync to the disk
};

/// The range of this rank if each rank has `count` rows, and their sum. Collective.
struct Spread {
  RowRange mine;
  std::uint64_t all = 0;
};
Spread spreadRows(MPI_Comm comm, std::uint64_t count);

/// Writes the file and renames it to `path`. Folders must exist. On failure, throws the same IoError on all
/// ranks; what was at `path` before is then still there, and no ".part" is left. Collective.
void writeParallelFile(const std::string& path, MPI_Comm comm, const ParallelFileContent& content);

/// Sum over rows of a hash of (row number, bytes): sums of parts add up to that of the whole, whatever the
/// parts.
std::uint64_t checksumRows(const void* data, const RowRange& range, std::size_t rowBytes);

/// Rank 0: IoError if fewer than `bytes` are free where `path` is to be.
void requireFreeSpace(const std::string& path, std::uint64_t bytes);

/// Renames a finished file and makes the rename itself durable if `sync`.
void renameFile(const std::string& from, const std::string& to, bool sync);

/// Replaces a small text file by writing name.part and renaming it.
void replaceTextFile(const std::string& path, const std::string& text);

}  // namespace thaw
