// SPDX-License-Identifier: Apache-2.0
// Files that tests write on all ranks: their bytes, and errors that must be the same everywhere.
#pragma once
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <functional>

#include "io/checkpoint/checkpoint.hpp"
#include "io/hdf5/collective_error.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "tests/support/output_sample.hpp"

namespace thaw::test {

/// runs before MPI_Init in main
inline const bool romio = (useRomio(), std::signal(SIGXFSZ, SIG_IGN), true);

inline std::string bytesOfFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The message of the IoError that `work` throws, or empty. Fails the test if ranks differ.
inline std::string sameError(const std::function<void()>& work) {
  std::string message;
  try {
    work();
  } catch (const IoError& e) { message = e.what(); }
  std::uint64_t hash = std::hash<std::string>{}(message), low = hash, high = hash;
  MPI_Allreduce(MPI_IN_PLACE, &low, 1, MPI_UINT64_T, MPI_MIN, MPI_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, &high, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD);
  EXPECT_EQ(low, high) << message;
  return message;
}

inline const RunStamp stamp{"wax", "title = \"W\u00e4rme\"\n", false};

}  // namespace thaw::test
