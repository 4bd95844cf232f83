#include "parallel/sparse_exchange.hpp"

#include <algorithm>
#include <stdexcept>

namespace thaw {

std::vector<Message> sparseExchange(const Communicator& comm, const std::vector<Message>& out, int kind) {
  const int tag = comm.nextTag(kind);
  std::vector<Message> in;
  std::vector<MPI_Request> sends;
  for (const Message& m : out) {
    if (m.bytes.size() > (1u << 30)) throw std::length_error("a message of more than 1 GiB between two ranks");
    if (m.rank == comm.rank()) {
      in.push_back(m);
      continue;
    }
    sends.emplace_back();
    MPI_Issend(m.bytes.data(), static_cast<int>(m.bytes.size()), MPI_BYTE, m.rank, tag, comm.handle(), &sends.back());
  }
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
      in.push_back({status.MPI_SOURCE, std::vector<std::byte>(static_cast<std::size_t>(bytes))});
      MPI_Mrecv(in.back().bytes.data(), bytes, MPI_BYTE, &handle, MPI_STATUS_IGNORE);
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
  std::stable_sort(in.begin(), in.end(), [](const Message& a, const Message& b) { return a.rank < b.rank; });
  return in;
}

}  // namespace thaw
