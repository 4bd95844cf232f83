// SPDX-License-Identifier: Apache-2.0
// RAII wrappers for MPI: library start and end, a private communicator, exact reductions.
#pragma once
#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "core/fields/column.hpp"
#include "core/halo/halo.hpp"
#include "core/time/step_trace.hpp"
#include "parallel/communication_statistics.hpp"

namespace thaw {

/// MPI_Init and MPI_Finalize. Create one in main, before any other object of parallel/. Only the creating
/// thread may call MPI. MPI errors end the run on all ranks with MPI's message (MPI's default handler). An
/// exception that leaves main's try block through this object aborts all ranks, which would otherwise block
/// forever.
class MpiSession {
 public:
  MpiSession(int* argc, char*** argv) : exceptions_(std::uncaught_exceptions()) {
    returnLargeBlocks();
    int provided = 0;
    MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
  }
  ~MpiSession() {
    if (std::uncaught_exceptions() > exceptions_) MPI_Abort(MPI_COMM_WORLD, 1);
    MPI_Finalize();
  }
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;

 private:
  int exceptions_;
};

/// Largest chunk of a message, and largest number of elements in a reduction: MPI counts in 32 bits.
inline constexpr std::size_t largestChunk = std::size_t{1} << 30;
inline constexpr std::size_t smallestChunk = 64;

/// A duplicated communicator, which isolates the program's messages. All halos share it; it counts their
/// messages and bytes.
class Communicator {
 public:
  /// chunk: largest number of bytes sent at once (64 B to 1 GiB, where small values are for tests), equal on
  /// all ranks.
  explicit Communicator(MPI_Comm from = MPI_COMM_WORLD, std::size_t chunk = largestChunk)
      : chunk_(std::clamp(chunk, smallestChunk, largestChunk)) {
    MPI_Comm_dup(from, &handle_);
    MPI_Comm_rank(handle_, &rank_);
    MPI_Comm_size(handle_, &size_);
  }
  ~Communicator() { MPI_Comm_free(&handle_); }
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;
  MPI_Comm handle() const { return handle_; }
  int rank() const { return rank_; }
  int size() const { return size_; }
  std::size_t chunk() const { return chunk_; }
  /// Alternates the tag between sparse exchanges, so that messages of a rank one exchange ahead are not
  /// received early.
  int nextTag(int tag) const { return 2 * tag + static_cast<int>(exchanges_++ & 1u); }
  /// Communication statistics of this rank so far. Senders add to them.
  CommunicationStatistics& statistics() const { return statistics_; }
  /// Trace of waits and exchanges (not owned), or null.
  StepTrace* trace() const { return trace_; }
  void setTrace(StepTrace* trace) const { trace_ = trace; }

 private:
  mutable unsigned exchanges_ = 0;
  mutable CommunicationStatistics statistics_;
  mutable StepTrace* trace_ = nullptr;
  MPI_Comm handle_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1;
  std::size_t chunk_;
};

/// Counts the duration of a scope as waiting for other ranks.
class WaitMark {
 public:
  WaitMark(const Communicator& comm, MessagesFor purpose)
      : comm_(comm), purpose_(purpose), start_(StepTrace::Clock::now()) {}
  ~WaitMark() {
    const auto now = StepTrace::Clock::now();
    comm_.statistics()[purpose_].waited += std::chrono::duration<double>(now - start_).count();
    if (StepTrace* t = comm_.trace())
      t->add(TraceKind::Wait, static_cast<std::uint8_t>(purpose_), start_, now);
  }
  WaitMark(const WaitMark&) = delete;
  WaitMark& operator=(const WaitMark&) = delete;

 private:
  const Communicator& comm_;
  MessagesFor purpose_;
  StepTrace::Clock::time_point start_;
};

/// Records an exchange from its first message to its end, with the messages and bytes in between. Does
/// nothing without a trace.
class ExchangeMark {
 public:
  void begin(const Communicator& comm, MessagesFor purpose) {
    if (comm.trace() == nullptr) return;
    start_ = StepTrace::Clock::now();
    before_ = comm.statistics()[purpose];
  }
  void end(const Communicator& comm, MessagesFor purpose) const {
    if (comm.trace() == nullptr) return;
    const CommunicationStatistics::Sum& now = comm.statistics()[purpose];
    comm.trace()->add(TraceKind::Exchange, static_cast<std::uint8_t>(purpose), start_,
                      StepTrace::Clock::now(), now.messages - before_.messages, now.bytes - before_.bytes);
  }

 private:
  StepTrace::Clock::time_point start_{};
  CommunicationStatistics::Sum before_;
};

/// Reducer over MPI. maximum turns NaN into +infinity, so that it is never lost.
class MpiReducer : public Reducer {
 public:
  explicit MpiReducer(const Communicator& comm) : comm_(comm) {}
  int rank() const override { return comm_.rank(); }
  int size() const override { return comm_.size(); }
  void maximum(std::span<double> values) override {
    for (double& v : values)
      if (std::isnan(v)) v = HUGE_VAL;
    reduce(values, MPI_DOUBLE, MPI_MAX);
  }
  void sum(std::span<std::int64_t> values) override { reduce(values, MPI_INT64_T, MPI_SUM); }
  std::vector<WordStream> sparseAllToAll(std::vector<WordStream> lists) override;

 private:
  template<class T> void reduce(std::span<T> values, MPI_Datatype type, MPI_Op operation) {
    if (comm_.size() == 1) return;
    const WaitMark waiting(comm_, MessagesFor::Reduction);
    while (!values.empty()) {
      const std::size_t n = std::min(values.size(), comm_.chunk());
      MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(n), type, operation, comm_.handle());
      comm_.statistics().collectives++;
      values = values.subspan(n);
    }
  }

  const Communicator& comm_;
};

}  // namespace thaw
