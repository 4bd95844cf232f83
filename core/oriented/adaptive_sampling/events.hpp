// SPDX-License-Identifier: Apache-2.0
// Timed events of oriented bodies: weld, cut, crease, smooth (ST92).
#pragma once
#include "core/halo/halos.hpp"
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

struct EventDue {
  double time;  ///< s
  std::size_t body, event;
};

/// Returns the events in (from, to] (s) in order of execution: by time, then by their order in the scene.
std::vector<EventDue> eventsBetween(const Scene& scene, double from, double to);

/// Returns whether an event lies in (from, to].
bool eventsDue(const Scene& scene, double from, double to);

/// Applies the events in (from, to] (s) to the owned rows, in order. The change of a row depends only on its
/// own position, group and normal, so the result does not depend on the number of ranks.
void applyEvents(const OrientedView& view, Halos halos, double from, double to);

/// Returns the number of a cut among all cuts, at most 32: its two bits in Oriented::cutSides.
int cutNumber(const Scene& scene, std::size_t body, std::size_t event);
inline constexpr int mostCuts = 32;

/// Returns the side of a cut on which a position (m) lies: 1 or 2, or 0 away from the cut. reach: m, range of
/// the pair forces.
int sideOfCut(const OrientedEvent& cut, const SignedDistance* region, double reach, const Vec3d& x);

/// Returns the distance (m) of a position from a polyline.
double distanceToPath(const std::vector<Vec3d>& path, const Vec3d& x);

}  // namespace thaw
