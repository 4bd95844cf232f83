// SPDX-License-Identifier: Apache-2.0
// Events of oriented bodies that a weld has left without particles.
#pragma once
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// Event on a body that an earlier weld has made part of another one: it would affect no particle.
struct EventOfWelded {
  std::size_t body, event;              ///< the event
  std::size_t named, into;              ///< body it names, and body that contains this one
  const OrientedEvent* weld = nullptr;  ///< weld that joined them
};

/// Returns these events in order of execution. Events in the list join nothing. Welds without a body, or with
/// their own, are refused elsewhere.
std::vector<EventOfWelded> eventsOfWelded(const Scene& scene);

}  // namespace thaw
