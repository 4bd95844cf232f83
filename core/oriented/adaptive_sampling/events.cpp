// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/adaptive_sampling/events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/oriented/adaptive_sampling/adaptive_sampling.hpp"
#include "core/oriented/adaptive_sampling/redistribute_oriented.hpp"

namespace thaw {
namespace {

// Smallest distance of welded particles, in spacings. Rows of a lattice have a distance of 0.87, and
// Lennard-Jones would eject closer particles.
constexpr double weldApart = 0.75;

/// Returns the parameter of the nearest point on the line through a and b: 0 at a, 1 at b, not clamped.
double shareAlong(const Vec3d& a, const Vec3d& b, const Vec3d& x) {
  const double l2 = dot(b - a, b - a);
  return l2 > 0 ? dot(x - a, b - a) / l2 : 0;
}

/// Counts pairs of neighbours in two groups, from the rows of the first. Cuts are ignored.
std::int64_t pairsOf(const Oriented& o, const OrientedLists& lists, std::uint32_t group,
                     std::uint32_t other) {
  std::int64_t n = 0;
  for (std::size_t i = 0; i < o.owned; i++)
    for (std::uint32_t k = lists.first[i]; o.group[i] == group && k < lists.first[i + 1]; k++)
      n += o.group[lists.list[k]] == other;
  return n;
}

/// Returns particles of `other` on overlapping rims of a weld: free particles closer to a particle of `group`
/// than `apart` (m).
std::vector<std::uint32_t> overlappingRows(const Oriented& o, const OrientedLists& lists, std::uint32_t group,
                                           std::uint32_t other, double apart) {
  std::vector<std::uint32_t> rows;
  for (std::size_t i = 0; i < o.owned; i++) {
    bool crowded = false;
    for (std::uint32_t k = lists.first[i];
         o.group[i] == other && !(o.flags[i] & fixedPosition) && k < lists.first[i + 1]; k++) {
      const Vec3d r = o.position[lists.list[k]] - o.position[i];
      crowded = crowded || (o.group[lists.list[k]] == group && dot(r, r) < apart * apart);
    }
    if (crowded) rows.push_back(static_cast<std::uint32_t>(i));
  }
  return rows;
}

}  // namespace

double distanceToPath(const std::vector<Vec3d>& path, const Vec3d& x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < path.size(); k++) {
    const double share = std::clamp(shareAlong(path[k], path[k + 1], x), 0.0, 1.0);
    least = std::min(least, length(x - (path[k] + share * (path[k + 1] - path[k]))));
  }
  return least;
}

int sideOfCut(const OrientedEvent& cut, const SignedDistance* region, double reach, const Vec3d& x) {
  if (cut.tool == CutTool::Plane) return dot(x - cut.point, cut.normal) > 0 ? 1 : 2;
  if (cut.tool == CutTool::Box) return region->inside(x) ? 1 : 2;
  // the cut is the path swept along its direction; it ends at the ends of the path
  const Vec3d down = normalized(cut.direction);
  const auto flat = [&](const Vec3d& p) { return p - dot(p, down) * down; };
  const Vec3d place = flat(x);
  double least = cut.radius > 0 ? cut.radius : reach;
  int side = 0;
  for (std::size_t k = 0; k + 1 < cut.path.size(); k++) {
    const Vec3d a = flat(cut.path[k]), b = flat(cut.path[k + 1]);
    const double share = shareAlong(a, b, place);
    const bool first = k == 0, last = k + 2 == cut.path.size();
    if ((share < 0 && first) || (share > 1 && last)) continue;
    const Vec3d near = a + std::clamp(share, 0.0, 1.0) * (b - a);
    const double far = length(place - near);
    if (far >= least) continue;
    least = far;
    side = dot(cross(b - a, place - a), down) > 0 ? 1 : 2;
  }
  return side;
}

int cutNumber(const Scene& s, std::size_t body, std::size_t event) {
  int number = 0;
  for (std::size_t b = 0; b <= body; b++)
    for (std::size_t e = 0; e < (b == body ? event : s.oriented[b].events.size()); e++)
      number += s.oriented[b].events[e].kind == OrientedEventKind::Cut;
  return number;
}

std::vector<EventDue> eventsBetween(const Scene& s, double from, double to) {
  std::vector<EventDue> list;
  for (std::size_t b = 0; b < s.oriented.size(); b++)
    for (std::size_t e = 0; e < s.oriented[b].events.size(); e++)
      if (const double time = s.oriented[b].events[e].time; time > from && time <= to)
        list.push_back({time, b, e});
  std::stable_sort(list.begin(), list.end(),
                   [](const EventDue& a, const EventDue& b) { return a.time < b.time; });
  return list;
}

bool eventsDue(const Scene& s, double from, double to) { return !eventsBetween(s, from, to).empty(); }

void applyEvents(const OrientedView& w, Halos halos, double from, double to) {
  Oriented& o = w.oriented.rows;
  const std::vector<EventDue> list = eventsBetween(w.scene, from, to);
  for (const EventDue& due : list) {
    const OrientedBody& body = w.scene.oriented[due.body];
    const OrientedEvent& e = body.events[due.event];
    const bool shaped = (e.kind == OrientedEventKind::Cut && e.tool == CutTool::Box) ||
                        e.kind == OrientedEventKind::Smooth;
    const auto region = shaped ? makeSignedDistance(e.region) : nullptr;
    const PairPotential& p = w.work.potentials[due.body];
    // Number of affected particles: for a cut on its two sides, else in the first entry. For a weld, it is
    // the number of joined pairs.
    std::int64_t met[2] = {0, 0};
    const std::uint32_t group = static_cast<std::uint32_t>(due.body),
                        other = static_cast<std::uint32_t>(e.otherIndex);
    std::vector<std::uint32_t> dead;
    if (e.kind == OrientedEventKind::Weld) {
      met[0] = pairsOf(o, w.work.lists, group, other);
      dead = overlappingRows(o, w.work.lists, group, other, weldApart * p.spacing);
    }
    for (std::size_t i = 0; i < o.owned; i++) {
      const Vec3d x = o.position[i];
      if (e.kind == OrientedEventKind::Weld) {
        if (o.group[i] == other) o.group[i] = group;
        continue;
      }
      if (o.group[i] != group) continue;
      if (e.kind == OrientedEventKind::Crease) {
        if (distanceToPath(e.path, x) < (e.radius > 0 ? e.radius : p.spacing))
          o.flags[i] |= creased, met[0]++;
      } else if (e.kind == OrientedEventKind::Smooth) {
        if (!region->inside(x)) continue;
        met[0] += (o.flags[i] & creased) != 0;
        o.flags[i] = static_cast<std::uint8_t>(o.flags[i] & ~creased);
      } else {
        const auto side = static_cast<std::uint64_t>(sideOfCut(e, region.get(), p.reach, x));
        if (side > 0) met[side - 1]++;
        o.cutSides[i] |= side << (2 * cutNumber(w.scene, due.body, due.event));
      }
    }
    for (const std::uint32_t i : dead) removeRow(w, i, from > -never ? to - from : 0);
    w.counters.orientedDeaths += static_cast<std::int64_t>(dead.size());
    // the next event requires current rows on all ranks
    if (e.kind == OrientedEventKind::Weld && &due != &list.back()) redistributeAndUpdate(w, halos);
    halos.all.sum(met);
    if (met[0] == 0 || (e.kind == OrientedEventKind::Cut && met[1] == 0))
      w.work.idle.push_back({due.body, due.event});
  }
}

}  // namespace thaw
