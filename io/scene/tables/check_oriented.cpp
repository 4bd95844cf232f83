// SPDX-License-Identifier: Apache-2.0
// Checks events of oriented bodies against the other bodies and earlier events.
#include <fmt/format.h>

#include "core/oriented/adaptive_sampling/events.hpp"
#include "core/oriented/adaptive_sampling/welded_bodies.hpp"
#include "io/scene/tables/read_sections.hpp"

namespace thaw {
namespace {

const char* nameOf(OrientedEventKind kind) {
  switch (kind) {
    case OrientedEventKind::Weld: return "weld";
    case OrientedEventKind::Cut: return "cut";
    case OrientedEventKind::Crease: return "crease";
    case OrientedEventKind::Smooth: return "smoothing";
  }
  return "";
}

/// Returns the error for an event whose body, or the body that it welds, is part of another body at that
/// time.
std::string textOf(const Scene& s, const EventOfWelded& found) {
  const OrientedBody& body = s.oriented[found.body];
  const OrientedEvent& e = body.events[found.event];
  const std::string &gone = s.oriented[found.named].name, &into = s.oriented[found.into].name;
  const bool line = found.weld->where.line > 0 && found.weld->where.file == e.where.file;
  const std::string since = fmt::format("was merged into '{}' by the weld at {:g} s{}", into,
                                        found.weld->time,
                                        line ? fmt::format(" (line {})", found.weld->where.line) : "");
  if (found.named == found.body)
    return fmt::format("oriented body '{}': it {}: move this {} at {:g} s to '{}', or before that weld", gone,
                       since, nameOf(e.kind), e.time, into);
  return fmt::format("oriented body '{}': this weld at {:g} s names '{}', which {}: expected {}", body.name,
                     e.time, gone, since,
                     found.into == found.body ? "one weld of the two"
                                              : "other = \"" + into + "\", or a time before that weld");
}

}  // namespace

void checkOrientedEvents(SceneReading& x, std::vector<SceneError>& errors) {
  Scene& s = *x.scene;
  int cuts = 0;
  for (OrientedBody& b : s.oriented)
    for (OrientedEvent& e : b.events) {
      cuts += e.kind == OrientedEventKind::Cut;
      if (e.kind != OrientedEventKind::Weld) continue;
      for (std::size_t k = 0; k < s.oriented.size(); k++)
        if (s.oriented[k].name == e.other) e.otherIndex = static_cast<int>(k);
      if (e.other == b.name && !b.name.empty())
        errors.push_back({e.where, fmt::format("oriented body '{}': it cannot be welded to itself: expected "
                                               "the name of another oriented body",
                                               b.name)});
      if (e.otherIndex < 0 && !e.other.empty())
        errors.push_back(
            {e.where, fmt::format("oriented body '{}': weld: unknown oriented body '{}': expected "
                                  "the name of another [[oriented]]",
                                  b.name, e.other)});
    }
  if (cuts > mostCuts)
    errors.push_back({x.start, fmt::format("the scene has {} cuts of oriented bodies; expected at most {}",
                                           cuts, mostCuts)});
  for (const EventOfWelded& found : eventsOfWelded(s))
    errors.push_back({s.oriented[found.body].events[found.event].where, textOf(s, found)});
}

}  // namespace thaw
