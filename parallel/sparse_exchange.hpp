// Messages of any size to a few ranks, without anybody knowing how many to expect (NBX: Hoefler, Siebert, Lumsdaine 2010).
#pragma once
#include <cstddef>
#include <vector>

#include "parallel/communicator.hpp"

namespace thaw {

struct Message {
  int rank = 0;                  ///< receiver of what is sent, sender of what is received
  std::vector<std::byte> bytes;
};

/// Sends each message; returns what came in, ascending by sender (several from one sender in the order sent). Messages to
/// oneself are allowed. kind: a number of the purpose. Collective over the communicator. Messages above 1 GiB are not split: throws std::length_error.
std::vector<Message> sparseExchange(const Communicator& comm, const std::vector<Message>& out, int kind);

}  // namespace thaw
