// The trace of a run as one file for all ranks, in the Trace Event Format that ui.perfetto.dev and
// chrome://tracing open.
#pragma once
#include <string>

#include "core/time/step_trace.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// What to add to the times of this process's steady clock to get those of rank 0's (ns): 0 on the machine of
/// rank 0, else found from the quickest of some answers that go to and fro, good to half of their time.
/// Collective.
std::int64_t clockOffset(const Communicator& comm);

/// Each rank is a process; steps, phases and waits are slices on one thread of it, one in another, exchanges
/// are asynchronous slices beside it. Rank 0 takes the events of one rank after another, so that it never
/// holds those of all. Throws the same IoError on all ranks. Collective.
void writeTrace(const std::string& path, const Communicator& comm, const StepTrace& trace);

}  // namespace thaw
