#include "core/neighbours/neighbour_lists.hpp"

#include "core/neighbours/search.hpp"

namespace thaw {

void clearLists(NeighbourLists& lists, std::uint32_t owned, std::uint32_t dummy) {
  const std::size_t groups = owned / 8 + 2;
  lists.self.resize(8 * groups);
  lists.first.resize(groups);
  lists.count.resize(groups);
  lists.wet.resize(groups);
  lists.neighbours.resize(owned);
  lists.dummy = dummy;
  lists.innerGroups = lists.groups = 0;
}

void growList(NeighbourLists& lists, std::size_t n) { lists.list.resize(n + n / 4 + 4096); }

void growSearch(SearchBuffers& b, std::size_t n) {
  const std::size_t room = n + n / 2 + 64;
  b.x.resize(room);
  b.y.resize(room);
  b.z.resize(room);
  b.row.resize(room);
  for (AlignedVector<std::uint32_t>& found : b.found) found.resize(room + 32);
}

}  // namespace thaw
