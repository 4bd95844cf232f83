// A ball as a file of triangles, for the set-up of bodies that are meshes.
#pragma once
#include <string>

#include "parallel/communicator.hpp"

namespace thaw::bench {

/// A binary PLY file of a ball of radius 1 with 99,904 triangles in the folder for temporary files, written
/// by the first rank and removed at the end of its life. Collective, both. Throws std::runtime_error, on the
/// first rank, where it cannot be written.
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
