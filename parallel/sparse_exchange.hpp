// SPDX-License-Identifier: Apache-2.0
// Messages of any size to a few ranks. The number of messages to receive is not known (NBX: HSL10).
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "parallel/communicator.hpp"

namespace thaw {

struct Message {
  int rank = 0;  ///< destination of a sent message, source of a received one
  std::vector<std::byte> bytes;
};

/// Received messages. Their buffers are reused at the next exchange.
class ReceiveBuffer {
 public:
  std::span<const Message> messages() const { return {pool_.data(), used_}; }
  void clear() { used_ = 0; }
  /// Appends a message of n bytes.
  Message& add(int rank, std::size_t n);
  /// Extends message k by n bytes and returns their address.
  std::byte* extend(std::size_t k, std::size_t n);
  /// Sorts by sender, ascending; messages of one sender keep their order.
  void sort();

 private:
  std::vector<Message> pool_;
  std::size_t used_ = 0;
};

/// Sends each non-empty message; `in` receives all incoming ones, ascending by sender (several from one
/// sender in sending order). A rank may send messages to itself. kind: a distinct number per use, equal on
/// all ranks. Messages may have any length. Those longer than Communicator::chunk are sent in chunks. A full
/// chunk is always followed by another one, which may be empty. Collective over the communicator.
void sparseExchange(const Communicator& comm, std::span<const Message> out, ReceiveBuffer& in, int kind,
                    MessagesFor purpose);

/// As above with fresh buffers.
std::vector<Message> sparseExchange(const Communicator& comm, const std::vector<Message>& out, int kind,
                                    MessagesFor purpose);

}  // namespace thaw
