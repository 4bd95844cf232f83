// SPDX-License-Identifier: Apache-2.0
// Collective error handling: an error on one rank becomes an error on all, so that no rank enters a
// collective call alone.
#pragma once
#include <mpi.h>

#include <functional>
#include <string>

namespace thaw {

/// Throws the same IoError on all ranks if `problem` is not empty on some: that of the lowest such rank.
/// Collective.
void agree(MPI_Comm comm, const std::string& problem);

/// Runs `work` on each rank, then calls agree. `work` must not call collective functions after code that may
/// throw on some ranks only. Collective.
void runCollectively(MPI_Comm comm, const std::function<void()>& work);

/// Runs `work` on rank 0 only, then calls agree. Collective.
void onFirstRank(MPI_Comm comm, const std::function<void()>& work);

}  // namespace thaw
