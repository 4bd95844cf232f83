// MPI behind RAII: start and end of the library, a communicator of our own, exact reductions.
#pragma once
#include <mpi.h>

#include <cmath>
#include <exception>

#include "core/halo/halo.hpp"

namespace thaw {

/// MPI_Init and MPI_Finalize. Make one in main, before anything else of parallel/. Only the thread that made it may call MPI.
/// Errors of MPI itself end the run on all ranks with MPI's message (MPI's default handler). An exception that leaves main's
/// try block through this object ends all ranks too: the others would wait for this one for ever.
class MpiSession {
 public:
  MpiSession(int* argc, char*** argv) : exceptions_(std::uncaught_exceptions()) {
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

/// A duplicate of a communicator, so that our messages meet nobody else's.
class Communicator {
 public:
  explicit Communicator(MPI_Comm from = MPI_COMM_WORLD) {
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
  /// Alternates at each sparse exchange: a rank that is one exchange ahead must not be heard in the last one.
  int nextTag(int tag) const { return 2 * tag + static_cast<int>(exchanges_++ & 1u); }

 private:
  mutable unsigned exchanges_ = 0;
  MPI_Comm handle_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1;
};

/// Reducer over MPI. A NaN among the values of maximum is passed on as +infinity, so that it is never lost.
class MpiReducer : public Reducer {
 public:
  explicit MpiReducer(const Communicator& comm) : comm_(comm) {}
  int rank() const override { return comm_.rank(); }
  int size() const override { return comm_.size(); }
  void maximum(std::span<double> values) override {
    for (double& v : values)
      if (std::isnan(v)) v = HUGE_VAL;
    if (comm_.size() == 1) return;
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX, comm_.handle());
  }
  void sum(std::span<std::int64_t> values) override {
    if (comm_.size() == 1) return;
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_INT64_T, MPI_SUM, comm_.handle());
  }

 private:
  const Communicator& comm_;
};

}  // namespace thaw
