// SPDX-License-Identifier: Apache-2.0
// A ball as a triangle file, for the set-up of mesh bodies.
#pragma once
#include <string>

#include "parallel/communicator.hpp"

namespace thaw::bench {

/// A binary PLY file of a ball of radius 1 with 99,904 triangles in the folder for temporary files. The first
/// rank writes it; the destructor removes it. Both are collective. Throws std::runtime_error on the first
/// rank if the file cannot be written.
class BallFile {
 public:
  explicit BallFile(const Communicator& comm);
  ~BallFile();
  BallFile(const BallFile&) = delete;
  BallFile& operator=(const BallFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  const Communicator& comm_;
  std::string path_;
};

}  // namespace thaw::bench
