// SPDX-License-Identifier: Apache-2.0
// Ranks compare their calls before each collective call. A rank that fails, or calls another function, then
// does not block the others.
#pragma once
#include <mpi.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace thaw::python {

/// Ranks call different functions: on all ranks, or one of them has ended its function or failed in it.
struct DifferentCalls : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The state of these comparisons for one simulation.
struct Meeting {
  MPI_Comm comm = MPI_COMM_NULL;
  std::uint32_t here = 0;   ///< bits of the kinds of functions that this rank has (FunctionKind)
  std::uint32_t onAny = 0;  ///< bits of all ranks at the last meeting
  bool unmet = false;       ///< the last meeting threw
};

/// Returns if all ranks call `what`, such as "sim.gather('density')". Throws DifferentCalls on all ranks
/// otherwise. Called without the interpreter's lock. Collective.
void meet(Meeting& meeting, const std::string& what);

/// Returns when all ranks have ended the functions of a phase. Called without the interpreter's lock.
/// Collective.
void meetAtEnd(Meeting& meeting);

}  // namespace thaw::python
