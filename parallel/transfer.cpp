// SPDX-License-Identifier: Apache-2.0
#include "parallel/transfer.hpp"

namespace thaw {

void startSend(const Communicator& comm, const std::byte* from, std::size_t bytes, int to, int tag,
               MessagesFor purpose, std::vector<MPI_Request>& requests) {
  for (std::size_t done = 0; done < bytes; done += comm.chunk()) {
    const std::size_t n = std::min(comm.chunk(), bytes - done);
    MPI_Isend(from + done, static_cast<int>(n), MPI_BYTE, to, tag, comm.handle(), &requests.emplace_back());
    comm.statistics().sent(purpose, n);
  }
}

void startReceive(const Communicator& comm, std::byte* to, std::size_t bytes, int from, int tag,
                  std::vector<MPI_Request>& requests) {
  for (std::size_t done = 0; done < bytes; done += comm.chunk())
    MPI_Irecv(to + done, static_cast<int>(std::min(comm.chunk(), bytes - done)), MPI_BYTE, from, tag,
              comm.handle(), &requests.emplace_back());
}

void finishAll(std::vector<MPI_Request>& requests) {
  if (!requests.empty()) MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  requests.clear();
}

}  // namespace thaw
