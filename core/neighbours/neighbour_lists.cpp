// SPDX-License-Identifier: Apache-2.0
#include "core/neighbours/neighbour_lists.hpp"

#include "core/neighbours/search.hpp"

namespace thaw {

void clearLists(NeighbourLists& lists, std::uint32_t owned, std::uint32_t dummy) {
  const std::size_t groups = owned / 8 + 2;
  const auto fit = [](auto& v, std::size_t n) {  // allocates exactly n; growth of the vector itself would
                                                 // double its capacity
    makeRoom(v, n);
    v.resize(n);
  };
  fit(lists.self, 8 * groups);
  fit(lists.first, groups);
  fit(lists.count, groups);
  fit(lists.fluid, groups);
  fit(lists.neighbours, owned);
  lists.dummy = dummy;
  lists.innerGroups = lists.groups = 0;
}

void growList(NeighbourLists& lists, std::size_t n) {
  // Estimates the size for all groups from the groups so far. Growth of the vector itself would double its
  // capacity.
  const std::size_t all = lists.self.size() / 8, done = lists.groups + 1;
  const std::size_t room = done < all / 8
                               ? 3 * n
                               : static_cast<std::size_t>(1.01 * static_cast<double>(n) *
                                                          static_cast<double>(all > done ? all : done) /
                                                          static_cast<double>(done));
  lists.list.reserve(room + 4096);
  lists.list.resize(room + 4096);
}

void growRounds(SearchBuffers& b) { b.rounds.resize(b.rounds.empty() ? 64 : 2 * b.rounds.size()); }

void growSearch(SearchBuffers& b, std::size_t n) {
  const std::size_t room = n + n / 2 + 64;
  b.x.resize(room);
  b.y.resize(room);
  b.z.resize(room);
  b.entry.resize(room);
  for (AlignedVector<std::uint32_t>& found : b.found) found.resize(room + 32);
}

}  // namespace thaw
