// SPDX-License-Identifier: Apache-2.0
#include "python/src/meeting.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace thaw::python {
namespace {

/// The function that a rank calls, and its kinds of functions.
struct Call {
  std::array<char, 60> what{};
  std::uint32_t kinds = 0;
};

constexpr const char* end = "";

std::string nameOf(const Call& call) { return {call.what.data()}; }

/// Returns the calls of all ranks.
std::vector<Call> allCalls(Meeting& m, const std::string& what) {
  int ranks = 0;
  MPI_Comm_size(m.comm, &ranks);
  Call mine;
  mine.kinds = m.here;
  what.copy(mine.what.data(), mine.what.size() - 1);
  std::vector<Call> all(static_cast<std::size_t>(ranks));
  MPI_Allgather(&mine, sizeof mine, MPI_BYTE, all.data(), sizeof mine, MPI_BYTE, m.comm);
  m.onAny = 0;
  for (const Call& call : all) m.onAny |= call.kinds;
  return all;
}

/// Returns the first rank that calls something else, or -1.
int firstOther(const std::vector<Call>& all, int rank) {
  for (std::size_t k = 0; k < all.size(); k++)
    if (all[k].what != all[static_cast<std::size_t>(rank)].what) return static_cast<int>(k);
  return -1;
}

bool isAlone(Meeting& m, int& rank) {
  int ranks = 0;
  MPI_Comm_size(m.comm, &ranks);
  MPI_Comm_rank(m.comm, &rank);
  if (ranks == 1) m.onAny = m.here;
  return ranks == 1;
}

}  // namespace

void meet(Meeting& m, const std::string& what) {
  int rank = 0;
  if (isAlone(m, rank)) return;
  const std::vector<Call> all = allCalls(m, what);
  const int other = firstOther(all, rank);
  if (other < 0) return;
  m.unmet = true;
  const std::string name = nameOf(all[static_cast<std::size_t>(other)]);
  throw DifferentCalls(what + ": rank " + std::to_string(other) +
                       (name == end ? " has ended its function without this call" : " calls " + name) +
                       "; all ranks have to call the same functions in the same order");
}

void meetAtEnd(Meeting& m) {
  int rank = 0;
  if (isAlone(m, rank)) return;
  while (firstOther(allCalls(m, end), rank) >= 0) {}
}

}  // namespace thaw::python
