// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/mesh/manifold.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <unordered_set>

#include "core/math/disjoint_sets.hpp"
#include "core/scene/shape.hpp"

namespace thaw {
namespace {

using Side = std::uint64_t;  // directed edge
Side sideOf(std::uint32_t from, std::uint32_t to) { return static_cast<Side>(from) << 32 | to; }

/// Directed edges of the accepted triangles. In a manifold, each occurs at most once.
struct Sides {
  std::unordered_set<Side> taken;
  bool has(std::uint32_t a, std::uint32_t b) const { return taken.contains(sideOf(a, b)); }
  bool takes(const Corners& t) const { return !has(t[0], t[1]) && !has(t[1], t[2]) && !has(t[2], t[0]); }
  void add(const Corners& t) {
    for (std::size_t k = 0; k < 3; k++) taken.insert(sideOf(t[k], t[(k + 1) % 3]));
  }
  void remove(const Corners& t) {
    for (std::size_t k = 0; k < 3; k++) taken.erase(sideOf(t[k], t[(k + 1) % 3]));
  }
};

/// Returns the squared circumradius over the squared spacing; `never` for collinear corners.
double roundness(const OrientedPoints& p, const Corners& t) {
  const Vec3d u = p.positions[t[1]] - p.positions[t[0]], v = p.positions[t[2]] - p.positions[t[0]], w = v - u,
              n = cross(u, v);
  const double area2 = dot(n, n);
  return area2 > 0 ? dot(u, u) * dot(v, v) * dot(w, w) / (4 * area2 * p.spacings[t[0]] * p.spacings[t[0]])
                   : never;
}

/// Returns whether the triangle's normal agrees with its particles' normals.
bool facesAlike(const OrientedPoints& p, const Corners& t) {
  const Vec3d n = cross(p.positions[t[1]] - p.positions[t[0]], p.positions[t[2]] - p.positions[t[0]]);
  return dot(n, p.normals[t[0]] + p.normals[t[1]] + p.normals[t[2]]) > 0;
}

/// Border edges in the direction around the hole: successors of each particle. A particle has several
/// successors only if the surface touches itself there.
using Borders = std::map<std::uint32_t, std::vector<std::uint32_t>>;
Borders bordersOf(const Sides& sides) {
  Borders next;
  for (const Side side : sides.taken) {
    const auto from = static_cast<std::uint32_t>(side >> 32), to = static_cast<std::uint32_t>(side);
    if (!sides.has(to, from)) next[to].push_back(from);
  }
  for (auto& [from, list] : next) std::sort(list.begin(), list.end());
  return next;
}

/// Returns the first successor clockwise at `at`, coming from `from`. The hole lies to the left.
std::uint32_t nextBorderVertex(const OrientedPoints& p, const std::vector<std::uint32_t>& ways,
                               std::uint32_t from, std::uint32_t at) {
  if (ways.size() == 1) return ways[0];
  const Vec3d n = p.normals[at], back = p.positions[from] - p.positions[at], u = back - dot(back, n) * n,
              v = cross(n, u);
  std::uint32_t best = ways[0];
  double least = never;
  for (const std::uint32_t way : ways) {
    const Vec3d d = p.positions[way] - p.positions[at];
    double turn = -std::atan2(dot(d, v), dot(d, u));  // clockwise
    if (turn <= 0) turn += 2 * std::numbers::pi;
    if (turn < least) least = turn, best = way;
  }
  return best;
}

/// Returns whether the loop is a hole, not the rim of a small patch. The normal of a hole agrees with its
/// particles' normals. In a sharp fold, it may not, but the particles' normals agree with each other and
/// their surface is large. The end of a narrow tube has mixed normals, and is not a hole. patch: number of
/// triangles of the surface.
bool isHole(const OrientedPoints& p, const std::vector<std::uint32_t>& hole, std::size_t patch) {
  Vec3d area{}, normal{};
  for (std::size_t k = 0; k < hole.size(); k++) {
    const Vec3d x = p.positions[hole[k]] - p.positions[hole[0]],
                y = p.positions[hole[(k + 1) % hole.size()]] - p.positions[hole[0]];
    area += cross(x, y);
    normal += p.normals[hole[k]];
  }
  return dot(area, normal) > 0 ||
         (patch > 6 * hole.size() && length(normal) > 0.5 * static_cast<double>(hole.size()));
}

/// Returns for each particle the number of triangles of its connected surface.
std::vector<std::size_t> sizesOfParts(std::size_t particles, const std::vector<Corners>& triangles) {
  DisjointSets sets(particles);
  for (const Corners& t : triangles) sets.join(t[0], t[1]), sets.join(t[1], t[2]);
  std::vector<std::size_t> count(particles, 0), sizes(particles);
  for (const Corners& t : triangles) count[sets.find(t[0])]++;
  for (std::uint32_t i = 0; i < particles; i++) sizes[i] = count[sets.find(i)];
  return sizes;
}

/// Clips ears off a hole until it is closed. Returns false if it stays open. facing: uses only ears whose
/// normals agree with their particles'.
bool closeHole(const OrientedPoints& p, std::vector<std::uint32_t> hole, const Sides& sides, bool facing,
               std::vector<Corners>& made) {
  made.clear();
  Sides fresh;
  while (hole.size() >= 3) {
    double best = never;
    std::size_t ear = hole.size();
    for (std::size_t k = 0; k < hole.size(); k++) {
      const Corners t{hole[k], hole[(k + 1) % hole.size()], hole[(k + 2) % hole.size()]};
      const bool last = hole.size() == 3;
      // the third edge must be free in both directions; that of the last ear is the hole's own
      if ((facing && !facesAlike(p, t)) || !sides.takes(t) || !fresh.takes(t) ||
          (!last && (sides.has(t[0], t[2]) || fresh.has(t[0], t[2]))))
        continue;
      if (const double r = roundness(p, t); r < best) best = r, ear = k;
    }
    if (ear == hole.size()) return false;
    made.push_back({hole[ear], hole[(ear + 1) % hole.size()], hole[(ear + 2) % hole.size()]});
    fresh.add(made.back());
    if (hole.size() == 3) break;
    hole.erase(hole.begin() + static_cast<std::ptrdiff_t>((ear + 1) % hole.size()));
  }
  return true;
}

void addAll(const std::vector<Corners>& made, Sides& sides, std::vector<Corners>& triangles) {
  for (const Corners& t : made) {
    sides.add(t);
    triangles.push_back(t);
  }
}

/// Traces a hole from one of its border edges. Returns nothing if the hole has too many edges, or an
/// edge that is too long (in spacings).
std::vector<std::uint32_t> traceHole(const OrientedPoints& p, const Borders& next, std::uint32_t start,
                                     std::uint32_t first, std::size_t mostSides, double longest) {
  std::vector<std::uint32_t> hole{start};
  for (std::uint32_t from = start, at = first; at != start;) {
    hole.push_back(at);
    const auto on = next.find(at);
    const double length2 = dot(p.positions[at] - p.positions[from], p.positions[at] - p.positions[from]);
    if (hole.size() > mostSides || on == next.end() ||
        !(length2 < longest * longest * p.spacings[at] * p.spacings[at]))
      return {};
    const std::uint32_t then = nextBorderVertex(p, on->second, from, at);
    from = at;
    at = then;
  }
  return hole;
}

/// Removes the triangles between the hole's own vertices, because they block its edges. Closes the resulting
/// holes.
void retriangulateHole(const OrientedPoints& p, const std::vector<std::uint32_t>& hole, Sides& sides,
                       std::vector<Corners>& triangles) {
  const auto inside = [&](const Corners& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t v) { return std::find(hole.begin(), hole.end(), v) != hole.end(); });
  };
  std::vector<Corners> kept, made, all;
  Sides trial = sides;
  for (const Corners& t : triangles) {
    if (inside(t)) trial.remove(t);
    else kept.push_back(t);
  }
  if (kept.size() == triangles.size()) return;
  const Borders next = bordersOf(trial);
  for (const std::uint32_t start : hole) {
    const auto ways = next.find(start);
    if (ways == next.end()) continue;
    for (const std::uint32_t first : ways->second) {
      if (trial.has(start, first)) continue;
      const std::vector<std::uint32_t> loop = traceHole(p, next, start, first, hole.size() + 2, never);
      if (loop.size() < 3 ||
          !(closeHole(p, loop, trial, true, made) || closeHole(p, loop, trial, false, made)))
        return;
      addAll(made, trial, all);
    }
  }
  sides = std::move(trial);
  triangles = std::move(kept);
  triangles.insert(triangles.end(), all.begin(), all.end());
}

}  // namespace

std::vector<Corners> keepManifold(const OrientedPoints& p, std::vector<Corners> triangles) {
  std::vector<double> round;
  for (const Corners& t : triangles) round.push_back(roundness(p, t));
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return round[a] != round[b] ? round[a] < round[b] : triangles[a] < triangles[b];
  });
  Sides sides;
  std::vector<Corners> kept;
  for (const std::uint32_t k : order) {
    if (!sides.takes(triangles[k])) continue;
    sides.add(triangles[k]);
    kept.push_back(triangles[k]);
  }
  return kept;
}

void fillHoles(const OrientedPoints& p, std::vector<Corners>& triangles, std::size_t mostSides,
               double longest) {
  Sides sides;
  for (std::size_t k = 0; k < triangles.size(); k++) sides.add(triangles[k]);
  const Borders next = bordersOf(sides);
  const std::vector<std::size_t> part = sizesOfParts(p.positions.size(), triangles);
  std::vector<Corners> made;
  std::vector<std::vector<std::uint32_t>> open;
  for (const auto& [start, ways] : next)
    for (const std::uint32_t first : ways) {
      if (sides.has(start, first)) continue;  // already filled
      const std::vector<std::uint32_t> hole = traceHole(p, next, start, first, mostSides, longest);
      if (hole.size() < 3 || !isHole(p, hole, part[start])) continue;
      // in a sharp fold, normals of ears may oppose their particles'
      if (closeHole(p, hole, sides, true, made) || closeHole(p, hole, sides, false, made))
        addAll(made, sides, triangles);
      else if (std::none_of(open.begin(), open.end(), [&](const auto& other) {
                 return std::is_permutation(other.begin(), other.end(), hole.begin(), hole.end());
               }))
        open.push_back(hole);
    }
  for (const std::vector<std::uint32_t>& hole : open) retriangulateHole(p, hole, sides, triangles);
}

}  // namespace thaw
