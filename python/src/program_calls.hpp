// SPDX-License-Identifier: Apache-2.0
// Functions of a Python program that a simulation calls, and what happens when they raise.
#pragma once
#include <mpi.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "python/src/arrays.hpp"
#include "python/src/meeting.hpp"

namespace thaw::python {

/// A function that may be destroyed by a thread without the interpreter's lock.
using Function = std::shared_ptr<const pybind11::function>;
Function keepFunction(const pybind11::object& function);

/// The calls of one simulation. The first exception is kept, since the step has to end first. Later calls
/// are made nevertheless: they may be collective.
struct ProgramCalls {
  std::optional<pybind11::error_already_set> failed;
  bool failedAfterOthers = false;  ///< `failed` is DifferentCalls, perhaps after an exception of another rank
  Meeting meeting;
  ColumnArrays arrays;
  int depth = 0;  ///< above 0 within a phase of a step, where rows are in use
};

/// Returns the calls of the simulation that this thread runs. Functions of extensions reach it
/// only in this way.
ProgramCalls& currentCalls();

/// Makes `calls` the current ones during its life.
class CallScope {
 public:
  explicit CallScope(ProgramCalls& calls);
  ~CallScope();
  CallScope(const CallScope&) = delete;
  CallScope& operator=(const CallScope&) = delete;

 private:
  ProgramCalls* before_;
};

/// Calls a function of the program with the interpreter's lock. Its exception is kept in currentCalls().
template<class Call> void guarded(const Call& call) {
  const pybind11::gil_scoped_acquire python;
  ProgramCalls& calls = currentCalls();
  std::optional<pybind11::error_already_set> error;
  calls.meeting.unmet = false;
  try {
    call();
  } catch (pybind11::error_already_set& e) {
    error.emplace(std::move(e));
  } catch (const pybind11::builtin_exception& e) {
    e.set_error();
    error.emplace();
  } catch (const std::exception& e) {  // such as a result of the wrong type
    PyErr_SetString(PyExc_RuntimeError, e.what());
    error.emplace();
  }
  if (!error || calls.failed) return;
  calls.failed = std::move(error);
  calls.failedAfterOthers = calls.meeting.unmet;
}

/// An exception of one rank, with its text on all ranks.
struct SharedFailure {
  int rank = -1;           ///< the first rank that has one; -1: none
  bool interrupt = false;  ///< KeyboardInterrupt, as of Ctrl-C and SIGTERM
  std::string text = {};   ///< "KeyError: 'mine'"
  explicit operator bool() const { return rank >= 0; }
};

/// Returns the failure of the first rank that has one, those of DifferentCalls last. Called without the
/// interpreter's lock. Collective.
SharedFailure shareFailure(ProgramCalls& calls, MPI_Comm comm);

/// Throws this rank's own exception, or one that names the rank that has failed.
[[noreturn]] void throwFailure(ProgramCalls& calls, const SharedFailure& failure);

}  // namespace thaw::python
