// Messages of any length between two ranks that both know it: MPI counts bytes in 32 bits, so long ones go in
// pieces. Pieces of one tag between two ranks arrive in the order in which they were sent.
#pragma once
#include <cstddef>
#include <vector>

#include "parallel/communicator.hpp"

namespace thaw {

/// Starts sending; the bytes must stay until finishAll(requests). Requests are appended. Counted as one
/// message for each piece.
void startSend(const Communicator& comm, const std::byte* from, std::size_t bytes, int to, int tag,
               MessagesFor purpose, std::vector<MPI_Request>& requests);

/// Starts receiving exactly so many bytes.
void startReceive(const Communicator& comm, std::byte* to, std::size_t bytes, int from, int tag,
                  std::vector<MPI_Request>& requests);

/// Waits for all, and empties the list.
void finishAll(std::vector<MPI_Request>& requests);

}  // namespace thaw
