// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/collective_error.hpp"

#include <new>

#include "io/hdf5/io_error.hpp"

namespace thaw {

void agree(MPI_Comm comm, const std::string& problem) {
  int rank = 0, size = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &size);
  int first = problem.empty() ? size : rank;
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, comm);
  if (first == size) return;
  std::string message = problem;
  int length = static_cast<int>(message.size());
  MPI_Bcast(&length, 1, MPI_INT, first, comm);
  message.resize(static_cast<std::size_t>(length));
  MPI_Bcast(message.data(), length, MPI_CHAR, first, comm);
  throw IoError(message);
}

void runCollectively(MPI_Comm comm, const std::function<void()>& work) {
  std::string problem;
  try {
    work();
  } catch (const std::bad_alloc&) { problem = "out of memory"; } catch (const std::exception& e) {
    problem = *e.what() != '\0' ? e.what() : "unknown error";
  }
  agree(comm, problem);
}

void onFirstRank(MPI_Comm comm, const std::function<void()>& work) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  runCollectively(comm, [&] {
    if (rank == 0) work();
  });
}

}  // namespace thaw
