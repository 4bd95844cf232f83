// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/adaptive_sampling/welded_bodies.hpp"

#include <numeric>

#include "core/oriented/adaptive_sampling/events.hpp"

namespace thaw {

std::vector<EventOfWelded> eventsOfWelded(const Scene& s) {
  std::vector<std::size_t> partOf(s.oriented.size());
  std::iota(partOf.begin(), partOf.end(), std::size_t{0});
  std::vector<const OrientedEvent*> by(s.oriented.size(), nullptr);
  std::vector<EventOfWelded> found;
  for (const EventDue& due : eventsBetween(s, -never, never)) {
    const OrientedEvent& e = s.oriented[due.body].events[due.event];
    const auto isGone = [&](std::size_t b) {
      if (partOf[b] != b) found.push_back({due.body, due.event, b, partOf[b], by[b]});
      return partOf[b] != b;
    };
    if (isGone(due.body) || e.kind != OrientedEventKind::Weld || e.otherIndex < 0) continue;
    const auto other = static_cast<std::size_t>(e.otherIndex);
    if (other == due.body || isGone(other)) continue;
    by[other] = &e;
    for (std::size_t& part : partOf)
      if (part == other) part = due.body;
  }
  return found;
}

}  // namespace thaw
