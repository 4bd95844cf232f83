// SPDX-License-Identifier: Apache-2.0
// HDF5 file of one process whose datasets grow, for data of many frames.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "io/hdf5/h5_file.hpp"

namespace thaw {

/// A file under a temporary name until `finish`. All functions throw IoError. Calls from several threads need
/// a lock, as for all of HDF5.
class GrowingFile {
 public:
  /// groups: created in this order.
  GrowingFile(std::filesystem::path path, const std::vector<std::string>& groups);
  ~GrowingFile();  ///< removes the temporary file unless finish() was called
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// Creates a dataset without rows; shape.rows is the number of rows of a chunk.
  void createDataset(const std::string& name, const DatasetShape& shape);
  /// Appends rows to a dataset of createDataset, in its element type.
  void append(const std::string& name, std::uint64_t rows, const void* data);
  /// Adds attributes and texts, and gives the file its name.
  void finish(const std::function<void(H5File&)>& addMore);

 private:
  [[noreturn]] void fail(const std::string& what) const;
  void close();
  std::filesystem::path path_, part_;
  std::int64_t id_ = -1;  // hid_t; -1: closed
  bool finished_ = false;
};

}  // namespace thaw
