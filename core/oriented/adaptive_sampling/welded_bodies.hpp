// SPDX-License-Identifier: Apache-2.0
// Events of oriented bodies that have no particles after a weld.
#pragma once
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// Event on a body that an earlier weld has joined to another body, so the event would affect no particle.
struct EventOfWelded {
  std::size_t body, event;              ///< the event
  std::size_t named, into;              ///< body in the event, and the body that it was joined to
  const OrientedEvent* weld = nullptr;  ///< weld that joined the two
};

/// Returns these events in order of execution. Welds in the result join nothing. Welds without another body
/// are refused elsewhere, as are welds of a body with itself.
std::vector<EventOfWelded> eventsOfWelded(const Scene& scene);

}  // namespace thaw
