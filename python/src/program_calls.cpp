// SPDX-License-Identifier: Apache-2.0
#include "python/src/program_calls.hpp"

#include <climits>
#include <stdexcept>

namespace py = pybind11;

namespace thaw::python {
namespace {

thread_local ProgramCalls* current = nullptr;

/// Returns "KeyError: 'mine'".
std::string textOf(const py::error_already_set& e) {
  return py::str(e.type().attr("__name__")).cast<std::string>() + ": " +
         py::str(e.value()).cast<std::string>();
}

}  // namespace

Function keepFunction(const py::object& function) {
  return {new py::function(function), [](const py::function* f) {
            if (!Py_IsInitialized()) return;  // the interpreter has freed it
            const py::gil_scoped_acquire python;
            delete f;
          }};
}

ProgramCalls& currentCalls() {
  if (!current) throw std::logic_error("a function of a Python program is called outside of a simulation");
  return *current;
}

CallScope::CallScope(ProgramCalls& calls) : before_(std::exchange(current, &calls)) {}
CallScope::~CallScope() { current = before_; }

SharedFailure shareFailure(ProgramCalls& calls, MPI_Comm comm) {
  SharedFailure f;
  int rank = 0, ranks = 0;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);
  int first = !calls.failed ? INT_MAX : calls.failedAfterOthers ? ranks + rank : rank;
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, comm);
  if (first == INT_MAX) return f;
  const bool hasCause = first < ranks;
  first %= ranks;
  f.rank = first;
  if (calls.failed && (rank == first || (hasCause && calls.failedAfterOthers))) {
    const py::gil_scoped_acquire python;
    if (rank == first) {
      f.interrupt = calls.failed->matches(PyExc_KeyboardInterrupt);
      f.text = textOf(*calls.failed);
    } else calls.failed.reset();
  }
  int head[] = {f.interrupt ? 1 : 0, static_cast<int>(f.text.size())};
  MPI_Bcast(head, 2, MPI_INT, first, comm);
  f.interrupt = head[0] != 0;
  f.text.resize(static_cast<std::size_t>(head[1]));
  MPI_Bcast(f.text.data(), head[1], MPI_CHAR, first, comm);
  return f;
}

void throwFailure(ProgramCalls& calls, const SharedFailure& failure) {
  if (calls.failed) {
    py::error_already_set error = std::move(*calls.failed);
    calls.failed.reset();
    throw error;
  }
  const std::string text = "rank " + std::to_string(failure.rank) + ": " + failure.text;
  if (!failure.interrupt) throw std::runtime_error(text);
  PyErr_SetString(PyExc_KeyboardInterrupt, text.c_str());
  throw py::error_already_set();
}

}  // namespace thaw::python
