// Events of oriented bodies that a weld has left without particles.
#pragma once
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// An event that names a body which is part of another one by then: no particle is of that body, so it would
/// do nothing.
struct EventOfWelded {
  std::size_t body, event;              ///< the event
  std::size_t named, into;              ///< the body that it names, and the one that this is part of
  const OrientedEvent* weld = nullptr;  ///< by which it has become so
};

/// All of them, in the order in which events are done. What is in the list joins nothing; nor do welds that
/// name no body, or their own, which are refused elsewhere.
std::vector<EventOfWelded> eventsOfWelded(const Scene& scene);

}  // namespace thaw
