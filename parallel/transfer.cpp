// SPDX-License-Identifier: Apache-2.0
#include "parallel/transfer.hpp"

namespace thaw {

void startSend(const Communicator& comm, std::span<const std::byte> bytes, Peer to, MessagesFor purpose,
               std::vector<MPI_Request>& requests) {
  for (std::size_t done = 0; done < bytes.size(); done += comm.chunk()) {
    const std::size_t n = std::min(comm.chunk(), bytes.size() - done);
    MPI_Isend(bytes.data() + done, static_cast<int>(n), MPI_BYTE, to.rank, to.tag, comm.handle(),
              &requests.emplace_back());
    comm.statistics().sent(purpose, n);
  }
}

void startReceive(const Communicator& comm, std::span<std::byte> bytes, Peer from,
                  std::vector<MPI_Request>& requests) {
  for (std::size_t done = 0; done < bytes.size(); done += comm.chunk())
    MPI_Irecv(bytes.data() + done, static_cast<int>(std::min(comm.chunk(), bytes.size() - done)), MPI_BYTE,
              from.rank, from.tag, comm.handle(), &requests.emplace_back());
}

void finishAll(std::vector<MPI_Request>& requests) {
  if (!requests.empty()) MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  requests.clear();
}

}  // namespace thaw
