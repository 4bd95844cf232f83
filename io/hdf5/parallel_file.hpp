// SPDX-License-Identifier: Apache-2.0
// Atomic output of one HDF5 file from all ranks. Rank 0 creates the layout as "name.part" and reserves its
// space. All ranks write their rows (independent MPI-IO writes of contiguous datasets). The file is opened
// again and checked; rank 0 appends a trailer with a checksum (file_trailer.hpp) and renames it. The layout
// is complete before other ranks open the file, so no metadata is written in parallel. A full disk is a
// failed write of one rank, reported on all.
#pragma once
#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

#include "io/hdf5/collective_error.hpp"
#include "io/hdf5/h5_file.hpp"

namespace thaw {

/// Dataset distributed over the ranks.
struct SpreadDataset {
  std::string name;            ///< path in the file
  DatasetShape shape;          ///< shape.rows: total over all ranks
  RowRange mine;               ///< rows of this rank
  const void* data = nullptr;  ///< mine.count rows; nullptr: `fill` makes them
  std::string unit;            ///< attribute "units"; empty: none
  /// Writes rows [first, first + count) of this rank (0: its first) to `to`. Called chunk by chunk; a chunk
  /// may be requested again.
  std::function<void(const RowRange& local, std::byte* to)> fill;
  std::string meaning = {};  ///< attribute "meaning"; empty: none
};

struct ParallelFileContent {
  std::vector<std::string> groups;      ///< parents before children
  std::vector<SpreadDataset> datasets;  ///< the same names and shapes on all ranks
  std::function<void(H5File&)> small;   ///< rank 0 only: texts, attributes, small datasets
  std::uint64_t smallBytes = 0;         ///< size of long texts in `small`
  bool checked = false;  ///< stores a checksum of each dataset (attribute "checksum"), reads all rows back to
                         ///< compare, and syncs to the disk
};

/// Row range of this rank if each rank has `count` rows (its own), and the number of rows of all ranks.
/// Collective.
struct Spread {
  RowRange mine;
  std::uint64_t all = 0;
};
Spread spreadRows(MPI_Comm comm, std::uint64_t count);

/// Writes the file and renames it to `path`, in an existing folder. On failure it throws the same IoError on
/// all ranks, keeps a previous file at `path`, and removes the ".part". Collective.
void writeParallelFile(const std::string& path, MPI_Comm comm, const ParallelFileContent& content);

/// Returns the sum over rows of a hash of (row number, bytes): sums of disjoint parts add up to that of the
/// whole.
std::uint64_t checksumRows(const void* data, const RowRange& range, std::size_t rowBytes);

/// Throws IoError if fewer than `bytes` are free at `path`. Call on rank 0.
void requireFreeSpace(const std::string& path, std::uint64_t bytes);

/// Renames a finished file; `sync` makes file and rename durable.
void renameFile(const std::string& from, const std::string& to, bool sync);

/// Replaces a small text file by writing name.part and renaming it.
void replaceTextFile(const std::string& path, const std::string& text);

}  // namespace thaw
