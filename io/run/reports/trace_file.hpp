// SPDX-License-Identifier: Apache-2.0
// The trace of a run as one file for all ranks, in the Trace Event Format that ui.perfetto.dev and
// chrome://tracing open.
#pragma once
#include <string>

#include "core/time/step_trace.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// Returns the offset (ns) from the steady clock of this process to that of rank 0. It is 0 on the machine of
/// rank 0. Elsewhere it comes from the quickest of several round trips, with an error of half its time.
/// Collective.
std::int64_t clockOffset(const Communicator& comm);

/// Writes the trace. Each rank is a process. Steps, phases and waiting times are nested slices of its thread,
/// and exchanges are asynchronous slices beside it. Rank 0 receives the events of one rank at a time, so that
/// it never holds all of them. Throws the same IoError on all ranks. Collective.
void writeTrace(const std::string& path, const Communicator& comm, const StepTrace& trace);

}  // namespace thaw
