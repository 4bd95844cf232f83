// Errors that one rank meets are errors of all: nobody may go on to a collective call that the others will
// not reach.
#pragma once
#include <mpi.h>

#include <functional>
#include <string>

namespace thaw {

/// Throws the same IoError on all ranks if `problem` is not empty on some: that of the lowest such rank.
/// Collective.
void agree(MPI_Comm comm, const std::string& problem);

/// Runs `work` (on this rank; it may throw anything), then agrees. `work` must not call collective functions
/// after a place where it may throw on some ranks only. Collective.
void agreeOn(MPI_Comm comm, const std::function<void()>& work);

/// The same for work of rank 0 alone.
void onFirstRank(MPI_Comm comm, const std::function<void()>& work);

}  // namespace thaw
