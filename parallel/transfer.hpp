// SPDX-License-Identifier: Apache-2.0
// Messages between two ranks, with a length known on both. MPI counts bytes in 32 bits, so long messages are
// split into chunks. Chunks of one tag between two ranks arrive in order.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "parallel/communicator.hpp"

namespace thaw {

/// The other rank of a message, and its tag.
struct Peer {
  int rank, tag;
};

/// Starts sending; the bytes must stay valid until finishAll(requests). Requests are appended. Each chunk
/// counts as one message.
void startSend(const Communicator& comm, std::span<const std::byte> bytes, Peer to, MessagesFor purpose,
               std::vector<MPI_Request>& requests);

/// Starts receiving exactly this number of bytes.
void startReceive(const Communicator& comm, std::span<std::byte> bytes, Peer from,
                  std::vector<MPI_Request>& requests);

/// Waits for all requests and empties the list.
void finishAll(std::vector<MPI_Request>& requests);

}  // namespace thaw
