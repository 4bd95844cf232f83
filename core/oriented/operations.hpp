// What the scene does to oriented bodies at a time: weld, cut, crease, smooth (ST92).
#pragma once
#include "core/step.hpp"

namespace thaw {

struct EventDue {
  double time;
  std::size_t body, event;
};

/// The events of (from, to] (s) in the order in which they are done: by time, then as in the scene.
std::vector<EventDue> eventsBetween(const Scene& scene, double from, double to);

/// Does an event lie in (from, to]?
bool operationDue(const Scene& scene, double from, double to);

/// Does the events of (from, to] (s) to the owned rows, in the order of time and then of the scene. The same
/// on any number of ranks: each looks at the row's own place, group and normal alone.
void operate(World& world, Halos halos, StepTools& tools, double from, double to);

/// Number of a cut among the cuts of all bodies: its two bits in Oriented::cutSides. At most 32.
int cutNumber(const Scene& scene, std::size_t body, std::size_t event);
inline constexpr int mostCuts = 32;

/// Side of a place at a cut: 0 not at it, 1 or 2. reach: m, of the pair forces.
int sideOfCut(const OrientedEvent& cut, const SignedDistance* region, double reach, const Vec3d& x);

/// Distance (m) of a place from a line through points.
double distanceToPath(const std::vector<Vec3d>& path, const Vec3d& x);

/// Brings rows home, with ghosts and lists, after flags, groups or rows have changed. Collective.
void readyAgain(World& world, Halos halos, StepTools& tools);

}  // namespace thaw
