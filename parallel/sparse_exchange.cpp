// SPDX-License-Identifier: Apache-2.0
#include "parallel/sparse_exchange.hpp"

#include <algorithm>

namespace thaw {

Message& ReceiveBuffer::add(int rank, std::size_t n) {
  if (used_ == pool_.size()) pool_.emplace_back();
  Message& m = pool_[used_++];
  m.rank = rank;
  m.bytes.resize(n);
  return m;
}

std::byte* ReceiveBuffer::extend(std::size_t k, std::size_t n) {
  std::vector<std::byte>& bytes = pool_[k].bytes;
  bytes.resize(bytes.size() + n);
  return bytes.data() + bytes.size() - n;
}

void ReceiveBuffer::sort() {  // insertion sort: few messages, no buffer
  for (std::size_t k = 1; k < used_; k++)
    for (std::size_t j = k; j > 0 && pool_[j].rank < pool_[j - 1].rank; j--)
      std::swap(pool_[j], pool_[j - 1]);
}

namespace {

/// Receives a probed chunk: the continuation of its sender's last message if that is in `open` (indices of
/// the receive buffer), else a new message.
void receiveChunk(const Communicator& comm, MPI_Message handle, const MPI_Status& status, ReceiveBuffer& in,
                  std::vector<std::size_t>& open) {
  int bytes = 0;
  MPI_Get_count(&status, MPI_BYTE, &bytes);
  const auto n = static_cast<std::size_t>(bytes);
  const auto at = std::find_if(open.begin(), open.end(),
                               [&](std::size_t k) { return in.messages()[k].rank == status.MPI_SOURCE; });
  std::byte* to = nullptr;
  if (at == open.end()) {
    to = in.add(status.MPI_SOURCE, n).bytes.data();
    if (n == comm.chunk()) open.push_back(in.messages().size() - 1);
  } else {
    to = in.extend(*at, n);
    if (n < comm.chunk()) open.erase(at);
  }
  MPI_Mrecv(to, bytes, MPI_BYTE, &handle, MPI_STATUS_IGNORE);
}

}  // namespace

void sparseExchange(const Communicator& comm, std::span<const Message> out, ReceiveBuffer& in, int kind,
                    MessagesFor purpose) {
  const int tag = comm.nextTag(kind);
  in.clear();
  std::vector<MPI_Request> sends;
  std::vector<std::size_t> open;
  for (const Message& m : out) {
    if (m.bytes.empty()) continue;
    if (m.rank == comm.rank()) {
      std::copy(m.bytes.begin(), m.bytes.end(), in.add(m.rank, m.bytes.size()).bytes.begin());
      continue;
    }
    for (std::size_t done = 0; done <= m.bytes.size(); done += comm.chunk()) {
      const std::size_t n = std::min(comm.chunk(), m.bytes.size() - done);
      MPI_Issend(m.bytes.data() + done, static_cast<int>(n), MPI_BYTE, m.rank, tag, comm.handle(),
                 &sends.emplace_back());
      comm.statistics().sent(purpose, n);
    }
  }
  if (comm.size() == 1) return;
  const WaitMark untilAllAreIn(comm, purpose);
  MPI_Request barrier = MPI_REQUEST_NULL;
  bool waiting = false;
  for (;;) {
    int found = 0;
    MPI_Message handle;
    MPI_Status status;
    MPI_Improbe(MPI_ANY_SOURCE, tag, comm.handle(), &found, &handle, &status);
    if (found) receiveChunk(comm, handle, status, in, open);
    int done = 0;
    if (!waiting) {
      MPI_Testall(static_cast<int>(sends.size()), sends.data(), &done, MPI_STATUSES_IGNORE);
      if (done) {
        MPI_Ibarrier(comm.handle(), &barrier);
        comm.statistics().collectives++;
        waiting = true;
      }
    } else {
      MPI_Test(&barrier, &done, MPI_STATUS_IGNORE);
      if (done) break;
    }
  }
  in.sort();
}

std::vector<Message> sparseExchange(const Communicator& comm, const std::vector<Message>& out, int kind,
                                    MessagesFor purpose) {
  ReceiveBuffer in;
  sparseExchange(comm, out, in, kind, purpose);
  return {in.messages().begin(), in.messages().end()};
}

}  // namespace thaw
