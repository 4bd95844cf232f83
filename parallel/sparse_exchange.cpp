#include "parallel/sparse_exchange.hpp"

#include <algorithm>
#include <stdexcept>

namespace thaw {

Message& Inbox::add(int rank, std::size_t n) {
  if (used_ == pool_.size()) pool_.emplace_back();
  Message& m = pool_[used_++];
  m.rank = rank;
  m.bytes.resize(n);
  return m;
}

void Inbox::sort() {  // by insertion: few messages, no buffer
  for (std::size_t k = 1; k < used_; k++)
    for (std::size_t j = k; j > 0 && pool_[j].rank < pool_[j - 1].rank; j--) std::swap(pool_[j], pool_[j - 1]);
}

void sparseExchange(const Communicator& comm, std::span<const Message> out, Inbox& in, int kind) {
  for (const Message& m : out)
    if (m.bytes.size() > largestMessage) throw std::length_error("a message of more than 1 GiB between two ranks");
  const int tag = comm.nextTag(kind);
  in.clear();
  std::vector<MPI_Request> sends;
  for (const Message& m : out) {
    if (m.bytes.empty()) continue;
    if (m.rank == comm.rank()) {
      std::copy(m.bytes.begin(), m.bytes.end(), in.add(m.rank, m.bytes.size()).bytes.begin());
      continue;
    }
    sends.emplace_back();
    MPI_Issend(m.bytes.data(), static_cast<int>(m.bytes.size()), MPI_BYTE, m.rank, tag, comm.handle(), &sends.back());
  }
  if (comm.size() == 1) return;
  MPI_Request barrier = MPI_REQUEST_NULL;
  bool waiting = false;
  for (;;) {
    int found = 0;
    MPI_Message handle;
    MPI_Status status;
    MPI_Improbe(MPI_ANY_SOURCE, tag, comm.handle(), &found, &handle, &status);
    if (found) {
      int bytes = 0;
      MPI_Get_count(&status, MPI_BYTE, &bytes);
      Message& m = in.add(status.MPI_SOURCE, static_cast<std::size_t>(bytes));
      MPI_Mrecv(m.bytes.data(), bytes, MPI_BYTE, &handle, MPI_STATUS_IGNORE);
    }
    int done = 0;
    if (!waiting) {
      MPI_Testall(static_cast<int>(sends.size()), sends.data(), &done, MPI_STATUSES_IGNORE);
      if (done) {
        MPI_Ibarrier(comm.handle(), &barrier);
        waiting = true;
      }
    } else {
      MPI_Test(&barrier, &done, MPI_STATUS_IGNORE);
      if (done) break;
    }
  }
  in.sort();
}

std::vector<Message> sparseExchange(const Communicator& comm, const std::vector<Message>& out, int kind) {
  Inbox in;
  sparseExchange(comm, out, in, kind);
  return {in.messages().begin(), in.messages().end()};
}

}  // namespace thaw
