// Messages of any size to a few ranks, without anybody knowing how many to expect (NBX: Hoefler, Siebert,
// Lumsdaine 2010).
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "parallel/communicator.hpp"

namespace thaw {

struct Message {
  int rank = 0;  ///< receiver of what is sent, sender of what is received
  std::vector<std::byte> bytes;
};

/// Messages that came in. Their buffers are used again at the next exchange.
class Inbox {
 public:
  std::span<const Message> messages() const { return {pool_.data(), used_}; }
  void clear() { used_ = 0; }
  /// A message of n bytes behind those that are there.
  Message& add(int rank, std::size_t n);
  /// Makes message k longer by n bytes and says where they go.
  std::byte* extend(std::size_t k, std::size_t n);
  /// Ascending by sender; messages of one sender stay in their order.
  void sort();

 private:
  std::vector<Message> pool_;
  std::size_t used_ = 0;
};

/// Sends each message that is not empty; `in` is what came in, ascending by sender (several from one sender
/// in the order sent). Messages to oneself are allowed. kind: a number of its own for each use, the same on
/// all ranks. Messages may have any length: what is longer than Communicator::piece travels in pieces, each
/// full one followed by another, if only an empty one. Collective over the communicator.
void sparseExchange(const Communicator& comm, std::span<const Message> out, Inbox& in, int kind,
                    MessagesFor purpose);

/// The same with fresh buffers.
std::vector<Message> sparseExchange(const Communicator& comm, const std::vector<Message>& out, int kind,
                                    MessagesFor purpose);

}  // namespace thaw
